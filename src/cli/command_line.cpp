#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <charconv>
#include <memory>

#include "cli/commands.hpp"
#include "engine/stop/duration.hpp"
#include "sigmasweep/model/fields.hpp"

namespace sigmasweep {
namespace {

/// "--steps-per-tc", and as in a spec.
std::string option_names(std::string_view name) {
  std::string dashed(name);
  std::replace(dashed.begin(), dashed.end(), '_', '-');
  return dashed == name ? "--" + dashed : fmt::format("--{},--{}", dashed, name);
}

/// What may be typed for a parameter: a number or a name. Whether it describes a tuple is for the spec to say.
CLI::Validator check_of(const Field& field) {
  const auto names = enumerators(field.type);
  if (!names.empty()) return CLI::IsMember(std::vector<std::string>(names.begin(), names.end())).description("");
  const bool real = field.type == FieldType::real;
  return CLI::Validator(
      [real](std::string& typed) {
        const char *begin = typed.data(), *end = begin + typed.size();
        double number;
        std::int64_t whole;
        const auto [rest, error] = real ? std::from_chars(begin, end, number) : std::from_chars(begin, end, whole);
        if (error == std::errc() && rest == end) return std::string();
        return fmt::format("'{}' is not a {}number", typed, real ? "" : "whole ");
      },
      "");
}

std::string type_name_of(const Field& field) {
  const auto names = enumerators(field.type);
  if (!names.empty()) return fmt::format("{}", fmt::join(names, "|"));
  return field.type == FieldType::real ? "NUMBER" : "INTEGER";
}

/// An option whose value `parse` reads into `target`; it returns nothing for what it cannot read.
template <class Parse, class Target>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, const std::string& meaning, Parse parse,
                        Target& target) {
  return command.add_option_function<std::string>(
      name,
      [name, parse, &target](const std::string& typed) {
        const auto value = parse(typed);
        if (!value) throw CLI::ValidationError(name, fmt::format("'{}' is not of the form expected", typed));
        target = *value;
      },
      meaning);
}

/// "3/8"
std::optional<Slice> parse_slice(const std::string& typed) {
  constexpr std::uint64_t most = 1'000'000;
  Slice slice;
  const char *begin = typed.data(), *end = begin + typed.size();
  const auto [slash, bad_index] = std::from_chars(begin, end, slice.index);
  if (bad_index != std::errc() || slash == end || *slash != '/') return std::nullopt;
  const auto [rest, bad_count] = std::from_chars(slash + 1, end, slice.count);
  if (bad_count != std::errc() || rest != end || slice.index >= slice.count || slice.count > most) return std::nullopt;
  return slice;
}

/// The command calls `function`, on every rank of mpirun.
template <class Options>
void call_on_all_ranks(CLI::App& command, Invocation& invocation, const std::shared_ptr<Options>& options,
                       int (*function)(int& argc, char**& argv, const Options&)) {
  command.callback([&invocation, options, function] {
    invocation.on_all_ranks = true;
    invocation.command = [&invocation, options, function] {
      return function(invocation.argc, invocation.argv, *options);
    };
  });
}

void add_run(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run a sweep, or go on with it; alone or under mpirun");
  command->add_option("spec", options->spec, "The sweep spec, a TOML file")->required()->type_name("SPEC.toml");
  command->add_option("-o,--output", options->output, "The table; default: the spec's name with .h5, here")
      ->type_name("TABLE.h5");
  command->add_flag("--fresh", options->fresh, "Start again, whatever is there");
  command->add_flag("--retry", options->retry, "Compute the rows again that were given up: time_limit, quarantined");
  command->add_flag("-q,--quiet", options->quiet, "Neither progress nor summary");
  add_parsed(*command, "--max-time", "Stop on purpose (exit code 75) to be through by then: seconds or [D-]HH:MM:SS",
             parse_duration, options->max_seconds)
      ->type_name("T");
  add_parsed(*command, "--max-seconds", "", parse_duration, options->max_seconds)->group("");
  add_parsed(*command, "--slice", "Only slice I (from 0) of N equal ones, to be joined by 'sigmasweep merge'",
             parse_slice, options->slice)
      ->type_name("I/N");
  command->add_flag("--extend", options->extend,
                    "The table there is of an earlier spec: take over the rows that are the same, then replace it");
  command->add_option("--reuse", options->reuse, "Take over rows that are the same from this table (may be repeated)")
      ->type_name("OTHER.h5")
      ->allow_extra_args(false);
  command->footer(
      "\nA run that was stopped or killed goes on where it was when it is started again with the same spec.\n"
      "Rows do not depend on the number of ranks. In a Slurm job the run also stops in time for the end of the job.\n\n"
      "  mpirun -n 4 sigmasweep run fig2a.toml -o fig2a.h5");
  call_on_all_ranks(*command, invocation, options, run_on_all_ranks);
}

void add_merge(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* command = app.add_subcommand("merge", "Join the tables of a sweep's slices");
  command->add_option("output", options->output, "The table to make")->required()->type_name("TABLE.h5");
  command->add_option("parts", options->parts, "Tables of the same spec that have all its rows together")
      ->required()
      ->type_name("PART.h5...");
  command->add_flag("--fresh", options->fresh, "Replace what is there");
  command->add_flag("-q,--quiet", options->quiet, "No summary");
  command->footer(
      "\nThe results are those of a run that was not divided, bit for bit. The parts are left as they are.\n\n"
      "  sigmasweep run fig2a.toml --slice 0/2 -o part0.h5\n"
      "  sigmasweep run fig2a.toml --slice 1/2 -o part1.h5\n"
      "  sigmasweep merge fig2a.h5 part0.h5 part1.h5");
  // The others only wait: MPI starts and ends with all.
  call_on_all_ranks(*command, invocation, options, merge_on_one_rank);
}

void add_precision(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<PrecisionOptions>();
  CLI::App* command = app.add_subcommand("precision", "Measure error against run time of every integrator");
  command->add_option("spec", options->spec, "A sweep spec with a table [precision]")
      ->required()
      ->type_name("SPEC.toml");
  command->add_option("-o,--output", options->output, "The table; default: the spec's name with .h5, here")
      ->type_name("TABLE.h5");
  command->add_option("--tuples", options->tuples, "Contact phases a scene, instead of the spec's")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000}).description(""))
      ->type_name("COUNT");
  command->add_option("--repeats", options->repeats, "Timings, of which the smallest counts, instead of the spec's")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1000}).description(""))
      ->type_name("COUNT");
  command->add_flag_callback(
      "--no-plots", [options] { options->plots = false; }, "No pictures");
  command->add_flag("-q,--quiet", options->quiet, "No progress");
  command->footer(
      "\nPrints a table and writes it to TABLE.h5, with TABLE.svg and TABLE.png beside it. Under mpirun each scene is\n"
      "measured by one rank; let mpirun bind ranks to cores (--bind-to core).\n\n"
      "  mpirun -n 2 --bind-to core sigmasweep precision precision.toml\n"
      "  sigmasweep precision precision.toml --tuples 10 --repeats 1");
  call_on_all_ranks(*command, invocation, options, precision_on_all_ranks);
}

void add_stability(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<StabilityOptions>();
  CLI::App* command = app.add_subcommand("stability", "Find out where the integrators of fixed step are stable");
  command->add_option("spec", options->run.spec, "A sweep spec with integrators of fixed step and steps_per_tc")
      ->required()
      ->type_name("SPEC.toml");
  command->add_option("-o,--output", options->run.output, "The table; default: the spec's name with .h5, here")
      ->type_name("TABLE.h5");
  command->add_flag("--fresh", options->run.fresh, "Start again, whatever is there");
  command->add_flag_callback(
      "--no-plots", [options] { options->plots = false; }, "No pictures");
  command->add_flag("-q,--quiet", options->run.quiet, "Neither progress nor summary");
  command->footer(
      "\nRuns the sweep, or goes on with it, as 'run' does, then prints what was seen beside what theory predicts,\n"
      "and draws both to TABLE.svg and TABLE.png. Rows that came out unstable are no failures here.\n\n"
      "  mpirun -n 2 sigmasweep stability stability.toml");
  call_on_all_ranks(*command, invocation, options, stability_on_all_ranks);
}

void add_plan(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App* command = app.add_subcommand("plan", "Check a sweep spec and say what it would take; nothing is run");
  command->add_option("spec", options->spec, "The sweep spec, a TOML file")->required()->type_name("SPEC.toml");
  command->add_option("--ranks", options->ranks, "For this many MPI ranks")
      ->check(CLI::Range(1, 1 << 20).description(""))
      ->capture_default_str()
      ->type_name("R");
  command->add_flag("--json", options->json, "One JSON document; times in seconds");
  command->footer("\n  sigmasweep plan fig2a.toml --ranks 64");
  command->callback([&invocation, options] { invocation.command = [options] { return plan(*options); }; });
}

void add_one(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<OneOptions>();
  CLI::App* command = app.add_subcommand("one", "Compute one tuple, now");
  for (const Field& field : parameter_fields()) {
    const std::string unit = field.unit == "1" ? "" : fmt::format(" ({})", field.unit);
    command
        ->add_option_function<std::string>(
            option_names(field.name),
            [options, name = field.name](const std::string& typed) { options->given[name] = typed; },
            std::string(field.meaning) + unit)
        ->check(check_of(field))
        ->type_name(type_name_of(field));
  }
  command->add_flag("--json", options->json, "One JSON document: field names and values");
  command->footer(
      "\nGive v0, N, s0 or sigma, and tc and epsilon, or K-over-m and D-n, or a material; the rest has defaults\n"
      "(method md, law hooke, integrator exact, wall paper). Vibrated columns need alpha or A0, but neither v0 nor a\n"
      "gap. A lattice needs rows (13 columns are the default) instead of N.\n\n"
      "  sigmasweep one --v0 1 --tc 2e-5 --s0 1e-6 --N 10 --epsilon 0.9\n"
      "  sigmasweep one --v0 1 --tc 2e-5 --sigma 0.05 --N 10 --epsilon 0.9 --integrator gear5 --steps-per-tc 500\n"
      "  sigmasweep one --v0 1 --tc 2e-5 --sigma 0.05 --N 10 --epsilon 0.9 --integrator gear5 --tolerance 1e-4\n"
      "  sigmasweep one --v0 1 --s0 0 --N 1 --law hertz --material steel\n"
      "  sigmasweep one --geometry vibrated-column --alpha 4 --frequency 20 --tc 1e-4 --N 10 --epsilon 0.92\n"
      "  sigmasweep one --geometry lattice --rows 10 --v0 0.05 --tc 2e-5 --s0 1e-7 --epsilon 0.9");
  command->callback([&invocation, options] { invocation.command = [options] { return one(*options); }; });
}

void add_plot(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* command = app.add_subcommand("plot", "Draw a table as its spec says");
  const auto scales = CLI::IsMember({"linear", "log"}).description("");
  command->add_option("table", options->table, "A table that 'run' or 'precision' wrote")
      ->required()
      ->type_name("TABLE.h5");
  command
      ->add_option("-o,--output", options->output,
                   "The picture, of several plots the first (others: FILE-name.svg); default: the table's name, here")
      ->type_name("FILE.svg|png|pdf");
  command->add_option("--name", options->name, "Only the plot of this name")->type_name("NAME");
  command
      ->add_option("--kind", options->kind,
                   "Another plot: error bars against run times, or where fixed time steps are stable")
      ->check(CLI::IsMember({"precision", "stability"}).description(""))
      ->type_name("precision|stability");
  command->add_option("--x", options->x, "Another field for the x axis, or an expression")->type_name("FIELD");
  command->add_option("--y", options->y, "Another field for the y axis, or an expression")->type_name("FIELD");
  command->add_option("--x-scale", options->x_scale, "Of the x axis")->check(scales)->type_name("linear|log");
  command->add_option("--y-scale", options->y_scale, "Of the y axis")->check(scales)->type_name("linear|log");
  command->add_option("--series", options->series, "Fields: one curve for each combination of their values")
      ->delimiter(',')
      ->type_name("FIELD,...");
  command->add_flag("-q,--quiet", options->quiet, "Print the files' names only, no fits");
  command->footer(
      "\nWith --x, --y, --x-scale, --y-scale or --series one plot is drawn, without the spec's fit and guides: the\n"
      "first, or that of --name.\n\n"
      "  sigmasweep plot fig2a.h5 -o fig2a.png\n"
      "  sigmasweep plot fig2a.h5 --x \"s0/v0\" --y \"1 - eps_eff\" --y-scale log -o loss.svg");
  command->callback([&invocation, options] { invocation.command = [options] { return plot(*options); }; });
}

void add_show(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<ShowOptions>();
  CLI::App* command = app.add_subcommand("show", "Look at a table");
  command->add_option("table", options->table, "A table that 'run' wrote")->required()->type_name("TABLE.h5");
  command->add_option("--where", options->where, "Only rows for which this holds, as in a spec")
      ->type_name("CONDITION");
  command->add_flag("--failed", options->failed, "Only failed rows, each with the command that repeats it");
  command
      ->add_option(
          "--limit", options->limit,
          fmt::format("At most this many rows, 0: all; default {}, with --json all", ShowOptions::default_limit))
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 40).description(""))
      ->type_name("ROWS");
  command->add_flag("--json", options->json, "One JSON document");
  command->footer("\n  sigmasweep show fig2a.h5 --where \"method == md && sigma > 1 && eps_eff < 0.5\" --limit 10");
  command->callback([&invocation, options] { invocation.command = [options] { return show(*options); }; });
}

void add_export(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "Write a table as CSV");
  command->add_option("table", options->table, "A table that 'run' wrote")->required()->type_name("TABLE.h5");
  command->add_option("-o,--output", options->output, "The file; default: standard output")->type_name("FILE.csv");
  command->add_flag("--timings", options->timings, "With run time, predicted time, rank and attempt");
  command->footer("\nRFC 4180, a header with the fields' names, numbers to the bit; nan where there is no result.");
  command->callback([&invocation, options] { invocation.command = [options] { return export_csv(*options); }; });
}

}  // namespace

void add_commands(CLI::App& app, Invocation& invocation) {
  add_run(app, invocation);
  add_merge(app, invocation);
  add_precision(app, invocation);
  add_stability(app, invocation);
  add_plan(app, invocation);
  add_one(app, invocation);
  add_plot(app, invocation);
  add_show(app, invocation);
  add_export(app, invocation);
}

}  // namespace sigmasweep

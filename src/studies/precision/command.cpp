#include "studies/precision/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "base/exit_codes.hpp"
#include "base/standard_error.hpp"
#include "engine/distribute/distribute.hpp"
#include "engine/report/progress.hpp"
#include "engine/report/provenance.hpp"
#include "engine/run.hpp"
#include "engine/stop/stop.hpp"
#include "mpi/on_root.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/table/place.hpp"
#include "studies/precision/measure.hpp"
#include "studies/precision/pictures.hpp"
#include "studies/precision/table.hpp"
#include "studies/precision/text.hpp"
#include "studies/sections.hpp"

namespace sigmasweep {
namespace {

using namespace exit_code;

Sweep with_precision(Sweep sweep, const std::string& spec) {
  if (!precision_of(sweep)) throw SpecError(fmt::format("{}: a precision study needs a table [precision]", spec));
  return sweep;
}

/// The spec's study with the values of the command line.
PrecisionSpec study_of(const Sweep& sweep, const PrecisionOptions& options) {
  PrecisionSpec study = *precision_of(sweep);
  if (options.tuples) study.tuples = *options.tuples;
  if (options.repeats) study.repeats = *options.repeats;
  return study;
}

/// The task of measuring one scene. Its answer are the rows of the scene, or none if it could not be measured.
struct SceneTask {
  std::uint64_t scene = 0;
  double predicted_seconds = 0.0;
  Parameters parameters;
};
using SceneJob = Job<SceneTask, std::vector<PrecisionRow>>;

std::vector<PrecisionRow> measure_scene(const SceneTask& task, const PrecisionSpec& study, int rank,
                                        std::int64_t ranks_per_core) {
  try {
    std::vector<PrecisionRow> rows = measure_precision(task.parameters, task.scene, study);
    for (PrecisionRow& row : rows) {
      row.rank = rank;
      row.ranks_per_core = ranks_per_core;
    }
    return rows;
  } catch (...) {
    return {};
  }
}

/// Predicted time of each scene, s.
std::vector<double> predicted_times(const Sweep& sweep, const PrecisionSpec& study) {
  std::vector<double> seconds;
  for (std::uint64_t scene = 0; scene < sweep.size(); ++scene)
    seconds.push_back(predicted_precision_time(sweep.at(scene), study));
  return seconds;
}

Schedule schedule_of(const std::vector<double>& predicted, int ranks) {
  std::vector<ScheduledTask> scenes;
  for (const double seconds : predicted) scenes.push_back({scenes.size(), seconds});
  return Schedule(std::move(scenes), ranks);
}

/// Measures all scenes on all ranks, each scene on one rank. Returns the rows, in order of scenes, on the manager;
/// `complete` if every scene was measured.
std::vector<PrecisionRow> measure(const World& world, const Sweep& sweep, const PrecisionSpec& study, bool quiet,
                                  bool& complete) {
  const auto ranks_per_core = static_cast<std::int64_t>(std::ceil(world.crowding()));
  const StopRequest stop;
  std::vector<double> predicted;  // on the manager
  std::optional<Schedule> schedule;
  std::optional<Progress> progress;
  if (world.is_manager()) {
    const Reporter reporter = Reporter::on_stderr(quiet);
    announce(reporter, sweep.size(), world.size());
    predicted = predicted_times(sweep, study);
    schedule.emplace(schedule_of(predicted, world.size()));
    progress.emplace(sweep.size(), schedule->total_seconds(), reporter);
  }
  std::vector<PrecisionRow> all;
  std::set<std::uint64_t> done;
  SceneJob job;
  job.task = [&](std::uint64_t scene, double seconds) { return SceneTask{scene, seconds, sweep.at(scene)}; };
  job.compute = [&, rank = world.rank()](const SceneTask& task, const std::function<bool()>&) {
    return std::optional(measure_scene(task, study, rank, ranks_per_core));
  };
  job.finished = [&](std::span<const std::vector<PrecisionRow>> answers) {
    for (const std::vector<PrecisionRow>& rows : answers) {
      if (rows.empty()) continue;
      all.insert(all.end(), rows.begin(), rows.end());
      done.insert(rows.front().scene);
      progress->add(1, predicted[rows.front().scene]);
    }
  };
  job.stop = [&] {
    if (progress) progress->add(0, 0.0);
    return stop.made();
  };
  distribute(world, schedule ? &*schedule : nullptr, job);
  if (progress) progress->finish();
  complete = done.size() == sweep.size();
  std::ranges::stable_sort(all, {}, &PrecisionRow::scene);
  return all;
}

/// The parameters that a table of the sweep has.
std::vector<Field> parameters_of(const Sweep& sweep) {
  std::vector<Field> parameters;
  for (const Field& column : sweep.columns())
    for (const Field& field : parameter_fields())
      if (field.name == column.name && field.name != "method") parameters.push_back(field);
  return parameters;
}

}  // namespace

int precision_study(World& world, const PrecisionOptions& options) {
  const std::string start = utc_now();
  std::optional<Sweep> sweep;
  const std::string table = options.output.empty() ? default_table(options.spec) : options.output;
  const int loaded = run_on_root(world, [&] {
    sweep = with_precision(Sweep::load(options.spec, study_sections, options.settings), options.spec);
    if (options.output.empty()) require_named_spec(options.spec);
    require_place_for_table(table, std::array{options.spec}, precision_format);
    return success;
  });
  if (loaded != success) return loaded;
  const std::string text = world.broadcast(sweep ? sweep->text() : "");
  if (!sweep) sweep = Sweep::parse(text, options.spec, study_sections);
  const PrecisionSpec study = study_of(*sweep, options);
  bool complete = false;
  const auto rows = measure(world, *sweep, study, options.quiet, complete);
  return run_on_root(world, [&] {
    if (!complete) {
      print_on_stderr("sigmasweep: stopped before all scenes were measured; nothing is written\n");
      return stopped;
    }
    fmt::print("{}", precision_text(rows, sweep->axes()));
    if (rows.front().ranks_per_core > 1)
      fmt::print("\n{} ranks shared a processor: the times are CPU times, but caches were shared, too\n",
                 rows.front().ranks_per_core);
    write_precision_table(table, table_info(*sweep, start, world.size()), parameters_of(*sweep), rows);
    print_on_stderr(table + "\n");
    for (const char* form : {".svg", ".png"})
      if (options.plots) draw_precision(*sweep, rows, named_after(table, form), "", stderr);
    return success;
  });
}

}  // namespace sigmasweep

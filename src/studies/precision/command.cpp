#include "studies/precision/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "base/exit_codes.hpp"
#include "engine/report/progress.hpp"
#include "engine/report/provenance.hpp"
#include "engine/run.hpp"
#include "engine/stop/stop.hpp"
#include "mpi/on_root.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "studies/precision/measure.hpp"
#include "studies/precision/pictures.hpp"
#include "studies/precision/table.hpp"

namespace sigmasweep {
namespace {

using namespace exit_code;

Sweep with_precision(Sweep sweep, const std::string& spec) {
  if (!sweep.precision()) throw SpecError(fmt::format("{}: a precision study needs a table [precision]", spec));
  return sweep;
}

/// The spec's study, with what the command line has instead.
PrecisionSpec study_of(const Sweep& sweep, const PrecisionOptions& options) {
  PrecisionSpec study = *sweep.precision();
  if (options.tuples) study.tuples = *options.tuples;
  if (options.repeats) study.repeats = *options.repeats;
  return study;
}

std::vector<PrecisionRow> gathered(const World& world, const std::vector<PrecisionRow>& mine) {
  std::string bytes(mine.size() * sizeof(PrecisionRow), '\0');
  if (!mine.empty()) std::memcpy(bytes.data(), mine.data(), bytes.size());
  std::vector<PrecisionRow> all;
  for (const std::string& each : world.gather(bytes)) {
    const std::size_t before = all.size();
    all.resize(before + each.size() / sizeof(PrecisionRow));
    if (!each.empty()) std::memcpy(all.data() + before, each.data(), each.size());
  }
  std::ranges::stable_sort(all, {}, &PrecisionRow::scene);
  return all;
}

/// All scenes on all ranks, each scene on one; the rows on the manager.
std::vector<PrecisionRow> measure(const World& world, const Sweep& sweep, const PrecisionSpec& study, bool quiet,
                                  bool& complete) {
  const auto ranks_per_core = static_cast<std::int64_t>(std::ceil(world.crowding()));
  const StopRequest stop;
  std::optional<Schedule> schedule;
  std::optional<Progress> progress;
  if (world.is_manager()) {
    std::vector<std::uint64_t> scenes;
    std::vector<double> seconds;
    for (std::uint64_t scene = 0; scene < sweep.size(); ++scene) {
      scenes.push_back(scene);
      seconds.push_back(predicted_precision_time(sweep.at(scene), study));
    }
    schedule.emplace(std::move(scenes), std::move(seconds), world.size());
    progress.emplace(sweep.size(), schedule->total_seconds(), world.size(), quiet);
  }
  std::vector<PrecisionRow> mine;
  std::set<std::uint64_t> done;
  Job job;
  job.tuple = [&](std::uint64_t scene) { return sweep.at(scene); };
  job.compute = [&](const Tuple& tuple, const std::function<bool()>&) {
    Row row{.index = tuple.index, .parameters = tuple.parameters, .result = {}, .timing = {}};
    try {
      for (PrecisionRow& each : measure_precision(tuple.parameters, tuple.index, study)) {
        each.rank = world.rank();
        each.ranks_per_core = ranks_per_core;
        mine.push_back(each);
      }
      row.result.status = Status::ok;
    } catch (...) {
      row.result.status = Status::failed;
    }
    row.timing.predicted_time = predicted_precision_time(tuple.parameters, study);
    return row;
  };
  job.finished = [&](const Row& row) {
    if (row.result.status == Status::ok) done.insert(row.index);
    progress->add(1, row.timing.predicted_time);
  };
  job.stop = [&] {
    if (progress) progress->add(0, 0.0);
    return stop.made();
  };
  distribute(world, schedule ? &*schedule : nullptr, job);
  if (progress) progress->finish();
  complete = done.size() == sweep.size();
  return gathered(world, mine);
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
  const int loaded = run_on_root(world, [&] {
    sweep = with_precision(Sweep::load(options.spec), options.spec);
    return success;
  });
  if (loaded != success) return loaded;
  const std::string text = world.broadcast(sweep ? sweep->text() : "");
  if (!sweep) sweep = Sweep::parse(text, options.spec);
  const PrecisionSpec study = study_of(*sweep, options);
  bool complete = false;
  const auto rows = measure(world, *sweep, study, options.quiet, complete);
  const std::string table = options.output.empty() ? default_table(options.spec) : options.output;
  return run_on_root(world, [&] {
    if (!complete) {
      fmt::print(stderr, "sigmasweep: stopped before all scenes were measured; nothing is written\n");
      return stopped;
    }
    fmt::print("{}", precision_text(rows, sweep->axes()));
    if (rows.front().ranks_per_core > 1)
      fmt::print("\n{} ranks shared a processor: the times are CPU times, but caches were shared, too\n",
                 rows.front().ranks_per_core);
    write_precision_table(table, table_info(*sweep, start, world.size()), parameters_of(*sweep), rows);
    fmt::print(stderr, "{}\n", table);
    for (const char* form : {".svg", ".png"})
      if (options.plots)
        draw_precision(*sweep, rows, std::filesystem::path(table).replace_extension(form).string(), "", stderr);
    return success;
  });
}

}  // namespace sigmasweep

// A run in process, on as many ranks as CTest starts this with: its phases one by one, and all of them together.
#include "engine/run.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>

#include "base/exit_codes.hpp"
#include "engine/ledger/identity.hpp"
#include "engine/phases/compute.hpp"
#include "engine/phases/limit_time.hpp"
#include "engine/phases/note_run.hpp"
#include "engine/phases/open.hpp"
#include "engine/phases/record_trajectories.hpp"
#include "engine/phases/report.hpp"
#include "engine/phases/write.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/solve/cost.hpp"
#include "store/journal/journal.hpp"
#include "store/table/read.hpp"

namespace sigmasweep {
namespace {

namespace fs = std::filesystem;

const World& world() {
  static int argc = 0;
  static char** argv = nullptr;
  static const World world(argc, argv);
  return world;
}

constexpr const char* six_rows = "[sweep]\nv0 = 0.1\ntc = 1e-5\nepsilon = 0.9\nN = [2, 3, 4]\nsigma = [0.5, 2.0]\n";
constexpr const char* nine_rows =
    "[sweep]\nv0 = 0.1\ntc = 1e-5\nepsilon = 0.9\nN = [2, 3, 4]\nsigma = [0.5, 1.0, 2.0]\n";

/// A directory of the test's own, the same on all ranks, with a spec in it; and what a run in it prints.
class Run : public testing::Test {
 protected:
  Run() {
    const auto name = fs::temp_directory_path() / ("sigmasweep-run-test-" + std::to_string(::getpid()));
    directory_ = world().broadcast(name.string());
    options_.spec = path("spec.toml");
    options_.output = path("table.h5");
    if (world().is_manager()) fs::create_directory(directory_);
    write_spec(six_rows);
  }
  ~Run() override {
    wait_for_all();
    if (world().is_manager()) fs::remove_all(directory_);
  }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  void write_spec(const char* text) const {
    if (world().is_manager()) std::ofstream(options_.spec) << text;
    wait_for_all();
  }
  static void wait_for_all() { MPI_Barrier(world().comm()); }
  Reporter reporter() {
    return Reporter([this](std::string_view text) { printed_ += text; }, options_.quiet);
  }
  int run() {
    printed_.clear();
    return run_sweep(world(), options_, reporter());
  }
  void expect_refusal() {
    if (world().is_manager())
      EXPECT_THROW(run(), OutputError);
    else
      EXPECT_EQ(run(), OutputError("").exit_code());
  }
  bool has_printed(std::string_view text) const {
    return !world().is_manager() || printed_.find(text) != std::string::npos;
  }

  fs::path directory_;
  RunOptions options_;
  std::string printed_;
};

void expect_same_results(const Table& a, const Table& b) {
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); ++k) {
    EXPECT_EQ(a.rows[k].result.status, b.rows[k].result.status);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a.rows[k].result.eps_eff),
              std::bit_cast<std::uint64_t>(b.rows[k].result.eps_eff));
  }
}

TEST_F(Run, WritesATableWithEveryRowOfTheSpec) {
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(has_printed("6 rows to compute")) << printed_;
  EXPECT_TRUE(has_printed("6 rows\n  ok")) << printed_;
  if (!world().is_manager()) return;
  const Table table = read_table(options_.output);
  const Sweep sweep = Sweep::load(options_.spec);
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.info.ranks, world().size());
  for (std::uint64_t row = 0; row < 6; ++row) {
    EXPECT_EQ(table.rows[row].parameters.N, sweep.at(row).N);
    EXPECT_EQ(table.rows[row].parameters.sigma, sweep.at(row).sigma);
    EXPECT_EQ(table.rows[row].result.status, Status::ok);
    EXPECT_EQ(table.rows[row].timing.predicted_time, predicted_time(sweep.at(row)));
  }
  EXPECT_FALSE(fs::exists(path("table.h5.journal")));
  EXPECT_FALSE(fs::exists(path("table.h5.running")));
}

TEST_F(Run, OfACompleteTableComputesNothing) {
  EXPECT_EQ(run(), exit_code::success);
  const auto time = world().is_manager() ? fs::last_write_time(options_.output) : fs::file_time_type();
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(has_printed("is complete, nothing to compute")) << printed_;
  if (world().is_manager()) {
    EXPECT_EQ(fs::last_write_time(options_.output), time);
  }
}

TEST_F(Run, WithOtherKeysIsThatOfAnotherSpec) {
  options_.settings = {"N=[5, 6]"};
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(has_printed("4 rows to compute")) << printed_;
  if (world().is_manager()) {
    const Table table = read_table(options_.output);
    EXPECT_EQ(table.rows.front().parameters.N, 5);
    EXPECT_TRUE(table.info.spec_text.ends_with("# set on the command line: N = [5, 6]\n")) << table.info.spec_text;
  }
  wait_for_all();
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(has_printed("is complete, nothing to compute")) << printed_;
  options_.settings.clear();
  expect_refusal();
}

TEST_F(Run, GoesOnWithTheSameKeysOnly) {
  options_.settings = {"N=[2, 3]"};
  options_.max_seconds = 0.0;
  EXPECT_EQ(run(), exit_code::stopped);
  wait_for_all();
  options_.max_seconds.reset();
  options_.settings = {"N=[5, 6]"};
  expect_refusal();
  options_.settings = {"N=[2, 3]"};
  EXPECT_EQ(run(), exit_code::success);
}

TEST_F(Run, IsQuietOnRequest) {
  options_.quiet = true;
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_EQ(printed_, "");
}

TEST_F(Run, WithoutTimeStopsAndGoesOnLater) {
  options_.max_seconds = 0.0;
  EXPECT_EQ(run(), exit_code::stopped);
  EXPECT_TRUE(has_printed("stopped on purpose with 0 of 6 rows done, its time was over before the first")) << printed_;
  EXPECT_FALSE(fs::exists(options_.output));
  wait_for_all();
  options_.max_seconds.reset();
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(fs::exists(options_.output));
}

TEST_F(Run, GoesOnWithTheRowsOfTheJournal) {
  if (world().is_manager()) {  // a run that died after two rows
    const Sweep sweep = Sweep::load(options_.spec);
    const std::vector<Field> results = journalled_results(sweep);
    Journal journal(options_.output, journal_identity(sweep, {}, results), true);
    for (const std::uint64_t row : {1u, 4u}) {
      Row done{.index = row, .parameters = sweep.at(row), .result = {}, .timing = {}};
      done.result.status = Status::ok;
      done.result.eps_eff = 0.125;
      journal.append(done);
    }
  }
  wait_for_all();
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(has_printed("going on with 2 of 6 rows")) << printed_;
  if (!world().is_manager()) return;
  const Table table = read_table(options_.output);
  for (std::uint64_t row = 0; row < 6; ++row) EXPECT_EQ(table.rows[row].result.eps_eff == 0.125, row == 1 || row == 4);
}

TEST_F(Run, RefusesTheTableOfAnotherSpecUnlessItExtendsIt) {
  EXPECT_EQ(run(), exit_code::success);
  write_spec(nine_rows);
  expect_refusal();
  options_.extend = true;
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(has_printed("going on with 6 of 9 rows, 6 of them taken over")) << printed_;
  options_.extend = false;
  options_.output = path("fresh.h5");
  EXPECT_EQ(run(), exit_code::success);
  if (world().is_manager()) expect_same_results(read_table(path("table.h5")), read_table(path("fresh.h5")));
}

TEST_F(Run, TellsOfAMissingSpecOnTheManagerAlone) {
  options_.spec = path("missing.toml");
  if (world().is_manager())
    EXPECT_THROW(run(), InputNotFound);
  else
    EXPECT_EQ(run(), InputNotFound("").exit_code());
}

TEST_F(Run, OfASliceHasItsRowsOnly) {
  options_.slice = {.index = 1, .count = 2};
  EXPECT_EQ(run(), exit_code::success);
  if (!world().is_manager()) return;
  const Table table = read_table(options_.output);
  ASSERT_EQ(table.rows.size(), options_.slice.size(6));
  for (std::uint64_t k = 0; k < table.rows.size(); ++k) EXPECT_EQ(table.rows[k].index, options_.slice.row(k));
}

TEST_F(Run, HasPhasesThatAreValues) {
  StopRequest stop;
  const Reporter report = reporter();
  OpenSweep open = open_sweep(world(), options_, report);
  EXPECT_EQ(open.rows(), 6u);
  EXPECT_FALSE(open.table_is_complete);
  EXPECT_EQ(open.ledger.has_value(), world().is_manager());

  std::optional<Deadline> deadline = limit_time(world(), open, 3600.0, stop, report);
  EXPECT_EQ(deadline.has_value(), world().is_manager());
  EXPECT_FALSE(stop.made());

  std::optional<NotedRun> noted(std::in_place, world(), open, report);
  EXPECT_TRUE(fs::exists(path("table.h5.running")));
  const Computed computed = compute_rows(world(), open, *noted, deadline, stop, report);
  EXPECT_TRUE(computed.is_complete);
  EXPECT_EQ(computed.work.rows, world().is_manager() ? 6u : 0u);
  EXPECT_FALSE(fs::exists(options_.output));

  write_rows(world(), open);
  EXPECT_EQ(open.table_rows().size(), 6u);
  noted.reset();
  if (world().is_manager()) {
    EXPECT_FALSE(fs::exists(path("table.h5.running")));
  }
  EXPECT_TRUE(record_trajectories(world(), open, stop, report));
  EXPECT_EQ(report_rows(world(), open, computed, report), exit_code::success);
}

TEST_F(Run, RecordsTheTrajectoriesOfTheSpec) {
  write_spec((std::string(six_rows) + "[trajectory]\nsamples = 10\nwhere = \"sigma > 1\"\n").c_str());
  EXPECT_EQ(run(), exit_code::success);
  EXPECT_TRUE(has_printed("3 trajectories in")) << printed_;
  for (const bool fast : {false, true})
    for (const int N : {2, 3, 4}) {
      const int row = 2 * (N - 2) + fast;
      EXPECT_EQ(fs::exists(path("table.trajectories/row-00000" + std::to_string(row) + ".h5")), fast) << row;
    }
}

}  // namespace
}  // namespace sigmasweep

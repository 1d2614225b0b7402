#include "engine/stop/last_resort.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "base/exit_codes.hpp"
#include "base/standard_error.hpp"
#include "engine/stop/stop.hpp"
#include "engine/stop/stop_signals.hpp"

namespace sigmasweep {
namespace {

using Clock = LastResort::Clock;

constexpr double patience = 33.0;  // s; the manager's is 30
constexpr double between_ranks = 0.1;

std::atomic<Clock::rep> stop_at = Clock::time_point::max().time_since_epoch().count();
std::atomic<double> allowed = 0.0;
std::atomic<int> together = 0;  ///< number of objects of that kind
std::mutex mutex;
std::function<std::string()> last_words;
std::function<bool()> is_some_rank_silent;

bool is_told_to_stop() { return StopSignals::came() || Clock::now().time_since_epoch().count() >= stop_at; }

std::string say_last_words() {
  const std::lock_guard lock(mutex);
  try {
    return last_words ? last_words() : "other ranks do not answer";
  } catch (...) {
    return "other ranks do not answer";
  }
}

bool somebody_is_silent() {
  const std::lock_guard lock(mutex);
  try {
    return is_some_rank_silent && is_some_rank_silent();
  } catch (...) {
    return false;
  }
}

constexpr std::chrono::seconds time_to_end(10);

}  // namespace

LastResort::LastResort(int rank) : rank_(rank), thread_([this](const std::stop_token& done) { watch(done); }) {}

LastResort::~LastResort() {
  thread_.request_stop();
  thread_.join();
  stop_at = Clock::time_point::max().time_since_epoch().count();
  allowed = 0.0;
  prepare_by({}, {});
}

LastResort::Together::Together() { ++together; }
LastResort::Together::~Together() { --together; }

void LastResort::expect_stop_in(double seconds) { stop_at = time_in(seconds).time_since_epoch().count(); }

void LastResort::allow(double seconds) { allowed = seconds; }

void LastResort::prepare_by(std::function<std::string()> words, std::function<bool()> silent) {
  const std::lock_guard lock(mutex);
  last_words = std::move(words);
  is_some_rank_silent = std::move(silent);
}

void LastResort::end_process_in(std::chrono::seconds seconds, int exit_code) {
  std::thread([=] {
    std::this_thread::sleep_for(seconds);
    std::_Exit(exit_code);
  }).detach();
}

void LastResort::end_all_ranks() {
  end_process_in(time_to_end, exit_code::stopped);
  int begun = 0, ended = 0;
  if (MPI_Initialized(&begun) == MPI_SUCCESS && begun && MPI_Finalized(&ended) == MPI_SUCCESS && !ended)
    MPI_Abort(MPI_COMM_WORLD, exit_code::stopped);
  std::_Exit(exit_code::stopped);
}

void LastResort::watch(const std::stop_token& done) const {
  const double mine = patience + between_ranks * std::min(rank_, 100);
  AwakeTime waiting;
  while (!done.stop_requested()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const bool is_told = is_told_to_stop();
    if (!is_told && together == 0) waiting = AwakeTime();
    if ((!is_told && together == 0) || waiting.look() < mine + allowed) continue;
    if (!is_told && !somebody_is_silent()) continue;  // they are slow
    end_process_in(time_to_end, exit_code::stopped);
    print_on_stderr(fmt::format(
        "sigmasweep: rank {}: the run {}: {}; it is given up. Everything done is kept, run it again to go on\n", rank_,
        is_told ? "does not end after it was told to stop" : "does not go on", say_last_words()));
    end_all_ranks();
  }
}

double AwakeTime::look() {
  const auto now = Clock::now();
  if (last_look_ != Clock::time_point{})
    seconds_ += std::min(1.0, std::chrono::duration<double>(now - last_look_).count());
  last_look_ = now;
  return seconds_;
}

}  // namespace sigmasweep

#include "python/compute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

#include "model/packing.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/solve/simulate.hpp"

namespace sigmasweep::python {
namespace {

constexpr std::size_t chunk = 256;  // tuples that a thread takes at a time

/// The work of all threads.
class Computation {
 public:
  Computation(std::span<const Given> given, std::size_t count, std::span<const Field> columns,
              std::span<std::byte> rows)
      : given_(given),
        gap_(is_given(given, "sigma") ? GapParameter::sigma : GapParameter::s0),
        count_(count),
        columns_(columns),
        rows_(rows),
        size_(packed_size(columns)) {}

  /// Takes tuples until there are none left, or one of the threads fails.
  void work() {
    try {
      while (!stop_) {
        const std::size_t first = next_.fetch_add(chunk);
        if (first >= count_) break;
        compute(first, std::min(count_, first + chunk));
      }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      stop_ = true;
      if (!failure_) failure_ = std::current_exception();
    }
    const std::scoped_lock lock(mutex_);
    ++finished_;
    changed_.notify_all();
  }

  /// Waits until so many threads have finished; false if it was interrupted.
  bool wait(int threads, const std::function<bool()>& interrupted) {
    std::unique_lock lock(mutex_);
    bool whole = true;
    while (!changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return finished_ == threads; })) {
      lock.unlock();
      if (interrupted()) stop_ = true, whole = false;
      lock.lock();
    }
    if (failure_) std::rethrow_exception(failure_);
    return whole;
  }

 private:
  void compute(std::size_t first, std::size_t end) const {
    std::vector<Parameters> tuples;
    for (std::size_t k = first; k < end; ++k) {
      tuples.push_back(complete(tuple_of(given_, k), gap_));
      if (const std::string why = why_invalid(tuples.back()); !why.empty())
        throw SpecError(fmt::format("tuple {}: {}", k, why));
    }
    std::vector<SimulationResult> results(tuples.size());
    std::vector<ComputeBudget> budgets(
        tuples.size(), ComputeBudget(std::numeric_limits<double>::infinity(), [this] { return stop_.load(); }));
    simulate_many(tuples, results, budgets);
    for (std::size_t i = 0; i < tuples.size(); ++i)
      pack(columns_, {.index = first + i, .parameters = tuples[i], .result = results[i], .timing = {}},
           &rows_[(first + i) * size_]);
  }

  std::span<const Given> given_;
  GapParameter gap_;
  std::size_t count_;
  std::span<const Field> columns_;
  std::span<std::byte> rows_;
  std::size_t size_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  int finished_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

bool compute(std::span<const Given> given, std::size_t count, std::span<const Field> columns, std::span<std::byte> rows,
             int threads, const std::function<bool()>& interrupted) {
  Computation computation(given, count, columns, rows);
  std::vector<std::jthread> team;
  for (int i = 0; i < threads; ++i) team.emplace_back([&] { computation.work(); });
  return computation.wait(threads, interrupted);
}

}  // namespace sigmasweep::python

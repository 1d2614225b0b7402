#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

namespace sigmasweep {

/// The limit of one simulation: a CPU time of the thread that uses the object, or a stop. Solvers check it in their
/// loops. Each simulation has an object of its own, which one thread uses. Its time begins with the first look at the
/// clock.
class ComputeBudget {
 public:
  /// `limit` is the CPU time, s. `stop` is called about every 20 ms; the solver throws the exceptions of `stop`.
  explicit ComputeBudget(double limit, std::function<bool()> stop = {});

  /// Whether the solver must give up; once true it stays true. `work` is the number of contact steps since the last
  /// call. The clock is read after each 10,000 contact steps, which take less than a millisecond in double precision.
  bool is_over(std::uint64_t work) {
    if (work < left_) {
      left_ -= work;
      return false;
    }
    return look();
  }

  bool was_over() const { return why_ != Why::not_yet; }
  bool was_stopped() const { return why_ == Why::stopped; }

 private:
  enum class Why { not_yet, time, stopped };
  using Clock = std::chrono::steady_clock;
  bool look();

  std::uint64_t left_;
  Why why_ = Why::not_yet;
  double limit_, cpu_start_;
  Clock::time_point start_{}, next_question_{};
  std::function<bool()> stop_;
};

}  // namespace sigmasweep

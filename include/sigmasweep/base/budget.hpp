#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

namespace sigmasweep {

/// How long one simulation may be computed: until the thread that made the object has used so much CPU time, or until a
/// stop is asked for. The solvers ask in their loops. There is one object for each simulation, used by one thread.
class ComputeBudget {
 public:
  /// `limit`: s. `stop` is called every 20 ms or so; what it throws, the solver throws.
  explicit ComputeBudget(double limit, std::function<bool()> stop = {});

  /// Whether to give up; once true it stays true. `work` is the work since the last question, as the number of contacts
  /// moved by a step. The clock is read after each 10,000 of these, a fraction of a millisecond in double.
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
  Clock::time_point start_, next_question_;
  std::function<bool()> stop_;
};

}  // namespace sigmasweep

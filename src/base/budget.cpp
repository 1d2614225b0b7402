#include "sigmasweep/base/budget.hpp"

#include <utility>

#include "base/thread_clock.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t work_between_looks = 10'000;
constexpr auto between_questions = std::chrono::milliseconds(20);

}  // namespace

ComputeBudget::ComputeBudget(double limit, std::function<bool()> stop)
    : left_(work_between_looks), limit_(limit), cpu_start_(0.0), stop_(std::move(stop)) {}

bool ComputeBudget::look() {
  if (was_over()) return true;
  left_ = work_between_looks;
  const auto now = Clock::now();
  if (start_ == Clock::time_point{}) {  // most tuples are finished before, and need no clock
    start_ = now;
    next_question_ = now + between_questions;
    cpu_start_ = thread_seconds();
  }
  // CPU time is never ahead of the wall clock, which costs less to read.
  if (std::chrono::duration<double>(now - start_).count() >= limit_ && thread_seconds() - cpu_start_ >= limit_)
    why_ = Why::time;
  if (stop_ && now >= next_question_) {
    next_question_ = now + between_questions;
    if (stop_()) why_ = Why::stopped;
  }
  if (was_over()) left_ = 0;
  return was_over();
}

}  // namespace sigmasweep

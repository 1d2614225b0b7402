#include "sigmasweep/solve/patience.hpp"

#include <ctime>
#include <utility>

namespace sigmasweep {
namespace {

constexpr std::uint64_t work_between_looks = 10'000;
constexpr auto between_questions = std::chrono::milliseconds(20);

/// Of the calling thread; 0 if the system has no such clock, and then there is no limit.
double cpu_seconds() {
  timespec now{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return 0.0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Patience::Patience(double limit, std::function<bool()> stop)
    : left_(work_between_looks), limit_(limit), cpu_start_(cpu_seconds()), start_(Clock::now()),
      next_question_(start_ + between_questions), stop_(std::move(stop)) {}

bool Patience::look() {
  if (was_over()) return true;
  left_ = work_between_looks;
  const auto now = Clock::now();
  // CPU time is never ahead of the wall clock, which costs less to read.
  if (std::chrono::duration<double>(now - start_).count() >= limit_ && cpu_seconds() - cpu_start_ >= limit_)
    why_ = Why::time;
  if (stop_ && now >= next_question_) {
    next_question_ = now + between_questions;
    if (stop_()) why_ = Why::stopped;
  }
  if (was_over()) left_ = 0;
  return was_over();
}

}  // namespace sigmasweep

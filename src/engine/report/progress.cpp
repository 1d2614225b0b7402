#include "engine/report/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/duration.hpp"

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds redraw_every(100), log_every(10'000);

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string bar(double fraction) {
  constexpr int width = 28;
  const int full = std::clamp(static_cast<int>(fraction * width), 0, width);
  return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", width - full);
}

}  // namespace

Progress::Progress(std::uint64_t total_rows, double total_predicted_seconds, int ranks, Reporter reporter)
    : total_rows_(total_rows),
      total_seconds_(total_predicted_seconds),
      ranks_(ranks),
      reporter_(std::move(reporter)),
      start_(Clock::now()),
      drawn_(start_) {
  if (!reporter_.is_terminal())
    reporter_.say(fmt::format("{} rows to compute on {} rank{}; predicted: {} of core time", total_rows_, ranks_,
                              ranks_ == 1 ? "" : "s", readable_duration(total_seconds_)));
}

void Progress::add(std::uint64_t rows, double predicted_seconds) {
  rows_ += rows;
  seconds_ += predicted_seconds;
  if (reporter_.is_quiet()) return;
  const auto since = Clock::now() - drawn_;
  if (reporter_.is_terminal() ? since >= redraw_every : since >= log_every) draw(false);
}

void Progress::finish() {
  if (!reporter_.is_quiet()) draw(true);
}

double Progress::fraction() const {
  if (total_rows_ == 0 || rows_ >= total_rows_) return 1.0;
  const double fraction =
      total_seconds_ > 0.0 ? seconds_ / total_seconds_ : static_cast<double>(rows_) / static_cast<double>(total_rows_);
  return std::clamp(fraction, 0.0, 1.0);
}

std::string Progress::state() const {
  const double elapsed = seconds_since(start_), done = fraction();
  const double rate = elapsed > 0.0 ? static_cast<double>(rows_) / elapsed : 0.0;
  std::string left;
  if (done < 1.0) left = ", left " + (done > 0.0 ? readable_duration(elapsed * (1.0 - done) / done) : "?");
  return fmt::format("{}/{} rows, {:.3g} rows/s, {}{}", rows_, total_rows_, rate, readable_duration(elapsed), left);
}

void Progress::draw(bool last) {
  drawn_ = Clock::now();
  if (reporter_.is_terminal()) {
    // back to the first column, the line, and nothing of the old one after it
    reporter_.show(
        fmt::format("\r{} {:5.1f} %  {}\x1b[K{}", bar(fraction()), 100.0 * fraction(), state(), last ? "\n" : ""));
  } else {
    reporter_.say(fmt::format("{:.1f} %, {}", 100.0 * fraction(), state()));
  }
}

}  // namespace sigmasweep

#include "engine/report/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/duration.hpp"

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds redraw_every(100), log_first(700), log_every(10'000);

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string bar(double fraction, int width) {
  const int full = std::clamp(static_cast<int>(fraction * width), 0, width);
  return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", width - full);
}

/// The bar and the text beside it, no longer than a line of the terminal: a line that is broken could not be redrawn.
std::string bar_line(double fraction, const std::string& text, int columns) {
  constexpr int widest = 28, narrowest = 8;
  std::string line = fmt::format(" {:5.1f} %  {}", 100.0 * fraction, text);
  const int room = columns - 1 - static_cast<int>(line.size()) - 2;
  if (room >= narrowest) line = bar(fraction, std::min(room, widest)) + line;
  return line.substr(0, static_cast<std::size_t>(std::max(columns - 1, 0)));
}

}  // namespace

void announce(const Reporter& reporter, std::uint64_t rows, int ranks) {
  reporter.say(fmt::format("{} rows to compute on {} rank{}", rows, ranks, ranks == 1 ? "" : "s"));
}

Progress::Progress(std::uint64_t total_rows, double total_predicted_seconds, Reporter reporter)
    : total_rows_(total_rows),
      total_seconds_(total_predicted_seconds),
      reporter_(std::move(reporter)),
      start_(Clock::now()),
      drawn_(start_) {
  reporter_.say(fmt::format("predicted: {} of core time", readable_duration(total_seconds_)));
  if (reporter_.is_terminal()) draw(false);
}

void Progress::add(std::uint64_t rows, double predicted_seconds) {
  rows_ += rows;
  seconds_ += predicted_seconds;
  if (is_due()) draw(false);
}

bool Progress::is_due() const {
  const auto since = Clock::now() - drawn_;
  if (reporter_.is_terminal()) return since >= redraw_every;
  return since >= (is_first_ ? log_first : log_every);
}

void Progress::finish() { draw(true); }

double Progress::fraction() const {
  if (total_rows_ == 0 || rows_ >= total_rows_) return 1.0;
  const double of_rows = static_cast<double>(rows_) / static_cast<double>(total_rows_);
  const double of_cost = total_seconds_ > 0.0 ? seconds_ / total_seconds_ : of_rows;
  return std::clamp(0.5 * (of_rows + of_cost), 0.0, 1.0);
}

RunProgress Progress::now() const {
  const double elapsed = seconds_since(start_), done = fraction();
  RunProgress progress{.done = rows_, .seconds = elapsed};
  if (done > 0.0) progress.seconds_left = elapsed * (1.0 - done) / done;
  return progress;
}

std::string Progress::state() const {
  const RunProgress progress = now();
  const double rate = progress.seconds > 0.0 ? static_cast<double>(rows_) / progress.seconds : 0.0;
  std::string left;
  if (fraction() < 1.0)
    left = ", left " + (std::isnan(progress.seconds_left) ? "?" : readable_duration(progress.seconds_left));
  return fmt::format("{}/{} rows, {:.3g} rows/s, {}{}", rows_, total_rows_, rate, readable_duration(progress.seconds),
                     left);
}

void Progress::draw(bool last) {
  drawn_ = Clock::now();
  is_first_ = false;
  if (reporter_.is_quiet()) return;
  if (reporter_.is_terminal()) {
    // back to the first column, the line, and nothing of the old one after it
    reporter_.show(fmt::format("\r{}\x1b[K{}", bar_line(fraction(), state(), reporter_.columns()), last ? "\n" : ""));
  } else {
    reporter_.say(fmt::format("{:.1f} %, {}", 100.0 * fraction(), state()));
  }
}

}  // namespace sigmasweep

#include "engine/report/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds redraw_every(100), log_every(10'000);

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Progress that cannot be written (a full disk under the log) is no reason to end a run.
void show(const std::string& text) {
  if (std::fputs(text.c_str(), stderr) < 0 || std::fflush(stderr) != 0) std::clearerr(stderr);
}

std::string bar(double fraction) {
  constexpr int width = 28;
  const int full = std::clamp(static_cast<int>(fraction * width), 0, width);
  return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", width - full);
}

}  // namespace

std::string readable_duration(double seconds) {
  if (!std::isfinite(seconds)) return "?";
  if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", seconds * 1e3);
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  const auto whole = std::llround(seconds);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  const auto minutes = std::llround(seconds / 60.0);
  if (minutes < 48 * 60) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  return fmt::format("{} d {} h", minutes / 1440, minutes % 1440 / 60);
}

Progress::Progress(std::uint64_t total_rows, double total_predicted_seconds, int ranks, bool quiet)
    : total_rows_(total_rows),
      total_seconds_(total_predicted_seconds),
      ranks_(ranks),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      drawn_(start_) {
  if (!quiet_ && !terminal_)
    show(fmt::format("sigmasweep: {} rows to compute on {} rank{}; predicted: {} of core time\n", total_rows_, ranks_,
                     ranks_ == 1 ? "" : "s", readable_duration(total_seconds_)));
}

void Progress::add(std::uint64_t rows, double predicted_seconds) {
  rows_ += rows;
  seconds_ += predicted_seconds;
  if (quiet_) return;
  const auto since = Clock::now() - drawn_;
  if (terminal_ ? since >= redraw_every : since >= log_every) draw(false);
}

void Progress::finish() {
  if (!quiet_) draw(true);
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
  if (terminal_) {
    // back to the first column, the line, and nothing of the old one after it
    show(fmt::format("\r{} {:5.1f} %  {}\x1b[K{}", bar(fraction()), 100.0 * fraction(), state(), last ? "\n" : ""));
  } else {
    show(fmt::format("sigmasweep: {:.1f} %, {}\n", 100.0 * fraction(), state()));
  }
}

}  // namespace sigmasweep

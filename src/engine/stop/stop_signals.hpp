#pragma once

#include <array>
#include <csignal>

namespace sigmasweep {

/// Signals that ask this process to stop, instead of killing it, while such an object lives: SIGTERM, SIGINT (Ctrl-C),
/// SIGHUP (a closed terminal), SIGQUIT, and SIGUSR1, SIGUSR2 and SIGXCPU, which batch systems send. A SIGHUP that is
/// ignored when the object is made stays ignored, as nohup wants it.
///
/// SIGPIPE asks for a stop where another process sent it. A write of this process into a closed pipe does not: the
/// write fails, and that is all.
///
/// Objects may be nested. The signals of the outermost one's life count for all.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Whether such a signal came.
  static bool came();

 private:
  static constexpr std::array signals_{SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGXCPU, SIGPIPE};
  std::array<struct sigaction, signals_.size()> before_{};
};

}  // namespace sigmasweep

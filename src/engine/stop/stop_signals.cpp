#include "engine/stop/stop_signals.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

namespace sigmasweep {
namespace {

std::atomic<bool> signalled = false;  // the one thing a signal handler may touch
static_assert(std::atomic<bool>::is_always_lock_free);

int objects = 0;  // of the main thread

void take_signal(int number, siginfo_t* info, void*) {
  const bool own_write = number == SIGPIPE && info->si_pid == ::getpid();
  if (!own_write) signalled = true;
}

}  // namespace

StopSignals::StopSignals() {
  if (objects++ == 0) signalled = false;
  struct sigaction action {};
  action.sa_sigaction = take_signal;
  action.sa_flags = SA_RESTART | SA_SIGINFO;  // the journal's writes are not cut short
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    if (sigaction(signals_[i], &action, &before_[i]) != 0)
      throw std::system_error(errno, std::generic_category(), "sigaction");
    const bool no_hangup = signals_[i] == SIGHUP && before_[i].sa_handler == SIG_IGN;
    if (no_hangup) sigaction(SIGHUP, &before_[i], nullptr);
  }
}

StopSignals::~StopSignals() {
  --objects;
  for (std::size_t i = 0; i < signals_.size(); ++i) sigaction(signals_[i], &before_[i], nullptr);
}

bool StopSignals::came() { return signalled; }

}  // namespace sigmasweep

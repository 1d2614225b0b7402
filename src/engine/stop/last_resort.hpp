#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace sigmasweep {

/// The last resort of a process that was told to stop: a thread that ends it, and all other ranks with it, if it has
/// not come to its end half a minute later. The same where all ranks do something together and one of them has been
/// silent for so long. It needs no other rank to answer: one that is stopped, lost or stuck in a file system would keep
/// the others waiting in MPI for ever. The exit code is exit_code::stopped.
///
/// Time during which this process itself was stopped does not count. There may be one such object at a time, from
/// before MPI begins until after its end.
class LastResort {
 public:
  using Clock = std::chrono::steady_clock;

  /// Half a minute, in which the manager names a rank that is silent, and some seconds more for a rank other than 0, so
  /// that one of them speaks.
  explicit LastResort(int rank);
  ~LastResort();
  LastResort(const LastResort&) = delete;
  LastResort& operator=(const LastResort&) = delete;

  /// The process is to stop in so many seconds, whether or not a signal comes. May be called before there is an object.
  static void expect_stop_in(double seconds);
  /// Gives the process so much time more, s: for work that is finished even after a stop.
  static void allow(double seconds);
  /// What is to be done before the end: `last_words` saves what can be saved, and says in words which ranks are silent.
  /// `is_some_rank_silent` tells the silent from the slow where there was no stop.
  static void prepare_by(std::function<std::string()> last_words, std::function<bool()> is_some_rank_silent);

  /// While it lives all ranks do something together, which no rank can go on without.
  class Together {
   public:
    Together();
    ~Together();
    Together(const Together&) = delete;
    Together& operator=(const Together&) = delete;
  };

  /// Ends this process in so many seconds, whatever hangs meanwhile.
  static void end_process_in(std::chrono::seconds seconds, int exit_code);
  /// Ends all ranks of this run now. MPI must not be asked whether the others are ready.
  [[noreturn]] static void end_all_ranks();

 private:
  void watch(const std::stop_token& done) const;
  int rank_;
  std::jthread thread_;
};

/// Time, s, that passes while this process is not itself stopped, as seen by somebody who looks several times a second.
class AwakeTime {
 public:
  /// Seconds since the first look.
  double look();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_look_{};
  double seconds_ = 0.0;
};

}  // namespace sigmasweep

#include "engine/distribute/thread_worker.hpp"

#include <utility>

namespace sigmasweep {

ThreadWorker::ThreadWorker(const ByteJob& job) : thread_([this, &job] { work(*this, job.compute_first); }) {}

ThreadWorker::~ThreadWorker() {
  say_quit();
  thread_.join();
}

void ThreadWorker::give(Bytes chunk) {
  const std::lock_guard lock(mutex_);
  chunks_.push_back(std::move(chunk));
  to_worker_.notify_one();
}

void ThreadWorker::say_quit() {
  const std::lock_guard lock(mutex_);
  quit_ = true;
  to_worker_.notify_one();
}

ThreadWorker::Mail ThreadWorker::collect(std::chrono::microseconds wait) {
  std::unique_lock lock(mutex_);
  to_manager_.wait_for(lock, wait, [this] { return !mail_.empty(); });
  return std::exchange(mail_, {});
}

ThreadWorker::Bytes ThreadWorker::next_chunk() {
  std::unique_lock lock(mutex_);
  to_worker_.wait(lock, [this] { return quit_ || !chunks_.empty(); });
  if (quit_) return {};
  auto chunk = std::move(chunks_.front());
  chunks_.pop_front();
  return chunk;
}

bool ThreadWorker::quit() {
  const std::lock_guard lock(mutex_);
  return quit_;
}

void ThreadWorker::add_to_mail(const Bytes& answers, bool is_last) {
  const std::lock_guard lock(mutex_);
  mail_.answers.insert(mail_.answers.end(), answers.begin(), answers.end());
  mail_.is_last = mail_.is_last || is_last;
  to_manager_.notify_one();
}

void ThreadWorker::deliver(Bytes answers) { add_to_mail(answers, false); }

void ThreadWorker::deliver_last(Bytes answers) { add_to_mail(answers, true); }

}  // namespace sigmasweep

#include "engine/distribute/thread_worker.hpp"

#include <utility>

namespace sigmasweep {

ThreadWorker::ThreadWorker(const ByteJob& job)
    : job_(job), queue_(job.task_size), thread_([this] { work(*this, job_); }) {}

ThreadWorker::~ThreadWorker() {
  say_quit();
  thread_.join();
}

void ThreadWorker::give(Bytes chunk) {
  const std::lock_guard lock(mutex_);
  queue_.add(std::move(chunk));
  to_worker_.notify_one();
}

std::size_t ThreadWorker::take_half() {
  const std::lock_guard lock(mutex_);
  return queue_.give_half();
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

ThreadWorker::Bytes ThreadWorker::next_batch() {
  std::unique_lock lock(mutex_);
  to_worker_.wait(lock, [this] { return quit_ || !queue_.empty(); });
  if (quit_) return {};
  return queue_.take(job_.batch_size(queue_.first_chunk()));
}

void ThreadWorker::put_back(std::span<const std::byte> tasks) {
  const std::lock_guard lock(mutex_);
  queue_.put_back(tasks);
}

bool ThreadWorker::is_between_chunks() {
  const std::lock_guard lock(mutex_);
  return queue_.is_between_chunks();
}

bool ThreadWorker::quit() {
  const std::lock_guard lock(mutex_);
  return quit_;
}

void ThreadWorker::add_to_mail(Bytes answers, bool is_last) {
  const std::lock_guard lock(mutex_);
  if (mail_.answers.empty())
    mail_.answers = std::move(answers);
  else
    mail_.answers.insert(mail_.answers.end(), answers.begin(), answers.end());
  mail_.is_last = mail_.is_last || is_last;
  to_manager_.notify_one();
}

void ThreadWorker::deliver(Bytes answers) { add_to_mail(std::move(answers), false); }

void ThreadWorker::deliver_last(Bytes answers) { add_to_mail(std::move(answers), true); }

}  // namespace sigmasweep

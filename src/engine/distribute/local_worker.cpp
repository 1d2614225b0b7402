#include "engine/distribute/local_worker.hpp"

#include <utility>

namespace sigmasweep {

LocalWorker::LocalWorker(const Compute& compute) : thread_([this, &compute] { work(*this, compute); }) {}

LocalWorker::~LocalWorker() {
  say_quit();
  thread_.join();
}

void LocalWorker::give(std::vector<Tuple> chunk) {
  const std::lock_guard lock(mutex_);
  chunks_.push_back(std::move(chunk));
  to_worker_.notify_one();
}

void LocalWorker::say_quit() {
  const std::lock_guard lock(mutex_);
  quit_ = true;
  to_worker_.notify_one();
}

LocalWorker::Mail LocalWorker::collect(std::chrono::microseconds wait) {
  std::unique_lock lock(mutex_);
  to_manager_.wait_for(lock, wait, [this] { return mail_.farewell || !mail_.rows.empty(); });
  return std::exchange(mail_, {});
}

std::vector<Tuple> LocalWorker::next_chunk() {
  std::unique_lock lock(mutex_);
  to_worker_.wait(lock, [this] { return quit_ || !chunks_.empty(); });
  if (quit_) return {};
  auto chunk = std::move(chunks_.front());
  chunks_.pop_front();
  return chunk;
}

bool LocalWorker::quit() {
  const std::lock_guard lock(mutex_);
  return quit_;
}

void LocalWorker::deliver(std::vector<Row> rows) {
  const std::lock_guard lock(mutex_);
  mail_.rows.insert(mail_.rows.end(), rows.begin(), rows.end());
  to_manager_.notify_one();
}

void LocalWorker::farewell(std::vector<Row> rows) {
  const std::lock_guard lock(mutex_);
  mail_.rows.insert(mail_.rows.end(), rows.begin(), rows.end());
  mail_.farewell = true;
  to_manager_.notify_one();
}

}  // namespace sigmasweep

#include "engine/distribute/task_queue.hpp"

#include <algorithm>
#include <utility>

namespace sigmasweep {

void TaskQueue::add(Bytes chunk) {
  if (chunk.empty() || chunk.size() % task_size_ != 0) throw wire::BadMessage();
  chunks_.push_back(std::move(chunk));
}

TaskQueue::Bytes TaskQueue::take(std::size_t tasks) {
  const auto left = first_chunk();
  const auto first = left.first(std::min(left.size(), tasks * task_size_));
  Bytes taken(first.begin(), first.end());
  taken_ += taken.size();
  if (taken.size() == left.size()) {
    chunks_.pop_front();
    taken_ = 0;
  }
  return taken;
}

void TaskQueue::put_back(std::span<const std::byte> tasks) {
  if (tasks.empty()) return;
  Bytes first(tasks.begin(), tasks.end());
  if (taken_ > 0) {  // they are from the same chunk
    const auto left = first_chunk();
    first.insert(first.end(), left.begin(), left.end());
    chunks_.pop_front();
    taken_ = 0;
  }
  chunks_.push_front(std::move(first));
}

std::size_t TaskQueue::count() const {
  std::size_t bytes = 0;
  for (const Bytes& chunk : chunks_) bytes += chunk.size();
  return (bytes - taken_) / task_size_;
}

std::size_t TaskQueue::give_half() {
  const std::size_t given = (count() + 1) / 2;
  for (std::size_t left = given * task_size_; left > 0;) {
    const std::size_t there = chunks_.back().size() - (chunks_.size() == 1 ? taken_ : 0);
    const std::size_t some = std::min(left, there);
    chunks_.back().resize(chunks_.back().size() - some);
    left -= some;
    if (some < there) continue;
    if (chunks_.size() == 1) taken_ = 0;
    chunks_.pop_back();
  }
  return given;
}

}  // namespace sigmasweep

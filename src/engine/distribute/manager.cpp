#include "engine/distribute/manager.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "engine/distribute/backoff.hpp"
#include "mpi/world_impl.hpp"

namespace sigmasweep {

Manager::Manager(const World& world, Schedule& schedule, const ByteJob& job)
    : workers_(world.impl().communicator),
      job_(job),
      worker_(static_cast<std::size_t>(world.size())),
      dispatcher_(schedule, world.size(), job.max_seconds) {
  if (job.manager_computes || world.size() == 1)
    own_worker_.emplace(job);
  else
    worker_[message::manager_rank].dismissed = worker_[message::manager_rank].gone = true;
  left_ = static_cast<int>(std::ranges::count(worker_, false, &Worker::gone));
}

void Manager::run() {
  for (int rank = 0; rank < workers_.size(); ++rank) supply(rank);
  for (Backoff backoff; left_ > 0;) {
    if (!stopped_ && job_.stop()) stop();
    const bool news = look_for_messages();
    if (look_at_own_worker(news ? Backoff::Duration(0) : backoff.next()) || news) {
      backoff.reset();
      supply_idle();  // there may be tasks that were given back, or that are short enough, now that more is known
    }
    sending_.remove_if([](Sending& sending) { return sending.request.test().has_value(); });
    ask_for_tasks();
    copy_overdue_tasks();
    tell_of_silent_ranks();
  }
  for (Sending& sending : sending_) sending.request.wait();
}

bool Manager::look_for_messages() {
  bool news = false;
  while (const auto message = workers_.iprobe()) {
    news = true;
    const int rank = message->source();
    const wire::Bytes bytes = message::receive(workers_, *message);
    if (message->tag() == message::given_back) {
      std::uint64_t tasks = 0;
      std::span<const std::byte> number(bytes);
      wire::take(number, tasks);
      take_back(rank, tasks);
      continue;
    }
    take(rank, bytes);
    if (message->tag() == message::stop) stop();
    if (message->tag() == message::last_answers) mark_gone(rank);
    supply(rank);
  }
  return news;
}

bool Manager::look_at_own_worker(std::chrono::microseconds wait) {
  if (!own_worker_ || worker_[message::manager_rank].gone) {
    if (wait.count() > 0) std::this_thread::sleep_for(wait);
    return false;
  }
  const ThreadWorker::Mail mail = own_worker_->collect(wait);
  take(message::manager_rank, mail.answers);
  if (mail.is_last) mark_gone(message::manager_rank);
  if (!mail.empty()) supply(message::manager_rank);
  return !mail.empty();
}

void Manager::take(int rank, const wire::Bytes& answers) {
  if (!answers.empty()) dispatcher_.heard_from(rank);
  job_.finished(answers, [&] {
    if (dispatcher_.is_idle(rank)) throw wire::BadMessage();  // an answer to no task
    return dispatcher_.answered(rank);
  });
}

void Manager::mark_gone(int rank) {
  worker_[rank].gone = true;
  --left_;
}

void Manager::supply(int rank) {
  if (worker_[rank].dismissed || dispatcher_.is_asked(rank)) return;
  for (auto tasks = dispatcher_.next(rank); !tasks.empty(); tasks = dispatcher_.next(rank)) give(rank, tasks);
  // A worker that has nothing to do stays: its rank may still be asked to stop the others.
  if (dispatcher_.is_idle(rank) && dispatcher_.out().all_are_back()) dismiss_all();
}

void Manager::supply_idle() {
  for (int rank = 0; rank < workers_.size(); ++rank)
    if (is_idle(rank)) supply(rank);
}

/// Asks a rank for tasks for each rank that has nothing to do.
void Manager::ask_for_tasks() {
  int idle = 0;
  for (int rank = 0; rank < workers_.size(); ++rank) idle += is_idle(rank);
  while (!stopped_ && dispatcher_.asked() < idle) {
    const auto rank = dispatcher_.next_to_give_back();
    if (!rank) return;
    if (*rank == message::manager_rank)
      take_back(*rank, own_worker_->take_half());
    else
      send(*rank, message::give_back, {});
  }
}

void Manager::take_back(int rank, std::uint64_t tasks) {
  dispatcher_.given_back(rank, tasks);
  if (stopped_) return;
  supply_idle();
  supply(rank);
}

void Manager::copy_overdue_tasks() {
  for (int rank = 0; rank < workers_.size(); ++rank) {
    if (!is_idle(rank) || dispatcher_.is_asked(rank)) continue;  // an idle one has been supplied: there is nothing else
    const auto tasks = dispatcher_.next_overdue(rank, job_.patience.overdue);
    if (tasks.empty()) return;  // nor is there anything for the other idle ranks
    give(rank, tasks);
  }
}

void Manager::tell_of_silent_ranks() {
  if (told_of_silent_ranks_ || !job_.silent || !std::ranges::all_of(worker_, &Worker::dismissed)) return;
  if (since_quit_.look() < job_.patience.silent) return;
  told_of_silent_ranks_ = true;
  std::vector<SilentRank> silent;
  for (int rank = 0; rank < workers_.size(); ++rank)
    if (!worker_[rank].gone) silent.push_back({rank, dispatcher_.out().first_missing(rank)});
  if (!silent.empty()) job_.silent(silent);
}

void Manager::give(int rank, const Dispatcher::Tasks& tasks) {
  wire::Bytes bytes;
  bytes.reserve(tasks.size() * job_.task_size);
  for (const ScheduledTask& task : tasks) job_.append_task(task.row, task.predicted_seconds, bytes);
  if (rank == message::manager_rank) return own_worker_->give(std::move(bytes));
  send(rank, message::chunk, std::move(bytes));
}

void Manager::send(int rank, message::Tag tag, wire::Bytes bytes) {
  Sending& sending = sending_.emplace_back(std::move(bytes), boost::mpi::request());
  sending.request = message::send(workers_, rank, tag, sending.bytes);
}

void Manager::dismiss(int rank) {
  worker_[rank].dismissed = true;
  if (rank == message::manager_rank) return own_worker_->say_quit();
  send(rank, message::quit, {});
}

void Manager::stop() {
  stopped_ = true;
  dismiss_all();
}

void Manager::dismiss_all() {
  for (int rank = 0; rank < workers_.size(); ++rank)
    if (!worker_[rank].dismissed) dismiss(rank);
}

}  // namespace sigmasweep

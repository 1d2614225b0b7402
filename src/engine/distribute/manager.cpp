#include "engine/distribute/manager.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "engine/distribute/backoff.hpp"
#include "mpi/world_impl.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t max_piece_tasks = 1024;  // ~300 kB a message; at 10 us a task still 10 ms of work
constexpr double prefetch_seconds = 0.05;      // fifty times the manager's longest sleep

}  // namespace

Manager::Manager(const World& world, Schedule& schedule, const ByteJob& job)
    : workers_(world.impl().communicator),
      schedule_(schedule),
      job_(job),
      worker_(static_cast<std::size_t>(world.size())),
      out_(world.size()) {
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
      if (job_.max_seconds) supply_idle();  // more tasks may be short enough, now that more is known of their times
    }
    sending_.remove_if([](Sending& sending) { return sending.request.test().has_value(); });
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
    take(rank, message::receive(workers_, *message));
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
  job_.finished(answers, [&] {
    if (out_.count(rank) == 0) throw wire::BadMessage();  // an answer to no task
    return out_.answered(rank);
  });
}

void Manager::mark_gone(int rank) {
  worker_[rank].gone = true;
  --left_;
}

void Manager::supply(int rank) {
  Worker& worker = worker_[rank];
  while (!worker.dismissed && wants_chunk(rank)) {
    const Schedule::Chunk piece = next_piece();
    if (!piece.empty()) {
      hand_out(rank, piece);
      continue;
    }
    // A worker that has nothing to do stays: its rank may still be asked to stop the others.
    if (out_.all_are_back()) dismiss_all();
    return;
  }
}

void Manager::copy_overdue_tasks() {
  for (int rank = 0; rank < workers_.size(); ++rank) {
    if (worker_[rank].dismissed || out_.count(rank) > 0) continue;  // it has been supplied: there is nothing else
    std::vector<std::uint64_t> rows;
    std::vector<double> seconds;
    for (const TasksOut::Task& task : out_.take_overdue(job_.patience.overdue)) {
      rows.push_back(task.row);
      seconds.push_back(task.predicted_seconds);
    }
    if (rows.empty()) return;  // nor is there anything for the other idle ranks
    hand_out(rank, {rows, seconds});
  }
}

void Manager::tell_of_silent_ranks() {
  if (told_of_silent_ranks_ || !job_.silent || !std::ranges::all_of(worker_, &Worker::dismissed)) return;
  if (since_quit_.look() < job_.patience.silent) return;
  told_of_silent_ranks_ = true;
  std::vector<SilentRank> silent;
  for (int rank = 0; rank < workers_.size(); ++rank)
    if (!worker_[rank].gone) silent.push_back({rank, out_.first_missing(rank)});
  if (!silent.empty()) job_.silent(silent);
}

void Manager::supply_idle() {
  for (int rank = 0; rank < workers_.size(); ++rank)
    if (out_.count(rank) == 0) supply(rank);
}

bool Manager::wants_chunk(int rank) const {
  const Worker& worker = worker_[rank];
  if (out_.count(rank) == 0) return true;
  return out_.count(rank) <= worker.last_chunk_tasks && worker.last_chunk_seconds < prefetch_seconds;
}

Schedule::Chunk Manager::next_piece() {
  if (piece_.empty()) piece_ = next_chunk();
  const std::size_t tasks = std::min(max_piece_tasks, piece_.size());
  return std::exchange(piece_, piece_.from(tasks)).first(tasks);
}

Schedule::Chunk Manager::next_chunk() {
  if (!job_.max_seconds) return schedule_.next();
  const double max_seconds = job_.max_seconds();
  Schedule::Chunk chunk = schedule_.next(max_seconds);
  if (chunk.empty() && !handed_out_ && max_seconds > 0.0) chunk = schedule_.shortest();
  handed_out_ = handed_out_ || !chunk.empty();
  return chunk;
}

void Manager::hand_out(int rank, const Schedule::Chunk& piece) {
  wire::Bytes tasks;
  double seconds = 0.0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    job_.append_task(piece.rows[i], piece.predicted_seconds[i], tasks);
    seconds += piece.predicted_seconds[i];
    out_.hand_out(rank, {piece.rows[i], piece.predicted_seconds[i]});
  }
  Worker& worker = worker_[rank];
  worker.last_chunk_tasks = piece.size();
  worker.last_chunk_seconds = seconds;
  if (rank == message::manager_rank) return own_worker_->give(std::move(tasks));
  send(rank, message::chunk, std::move(tasks));
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

#include "engine/distribute/manager.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "engine/distribute/backoff.hpp"
#include "engine/distribute/messages.hpp"
#include "mpi/world_impl.hpp"
#include "sigmasweep/sweep/cost.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t max_piece_rows = 1024;  // ~100 kB a message; at 10 us a row still 10 ms of work
constexpr double prefetch_seconds = 0.05;     // fifty times the manager's longest nap

}  // namespace

Manager::Manager(const World& world, Schedule& schedule, const Job& job)
    : workers_(world.impl().communicator), schedule_(schedule), job_(job), worker_(world.size()) {
  if (job.manager_computes || world.size() == 1)
    own_worker_.emplace(job.compute);
  else
    worker_[message::manager_rank].dismissed = worker_[message::manager_rank].gone = true;
  left_ = static_cast<int>(std::count_if(worker_.begin(), worker_.end(), [](const Worker& w) { return !w.gone; }));
}

void Manager::run() {
  for (int rank = 0; rank < workers_.size(); ++rank) supply(rank);
  for (Nap nap; left_ > 0;) {
    if (!stopped_ && job_.stop()) stop();
    const bool news = look_for_messages();
    if (look_at_own_worker(news ? Nap::Duration(0) : nap.next()) || news) nap.reset();
    sending_.remove_if([](Sending& sending) { return sending.request.test().has_value(); });
  }
  for (Sending& sending : sending_) sending.request.wait();
}

bool Manager::look_for_messages() {
  bool news = false;
  while (const auto message = workers_.iprobe()) {
    news = true;
    const int rank = message->source();
    take(rank, message::receive<Row>(workers_, *message));
    if (message->tag() == message::stop) stop();
    if (message->tag() == message::farewell) farewell(rank);
    supply(rank);
  }
  return news;
}

bool Manager::look_at_own_worker(std::chrono::microseconds wait) {
  if (!own_worker_ || worker_[message::manager_rank].gone) {
    if (wait.count() > 0) std::this_thread::sleep_for(wait);
    return false;
  }
  const auto mail = own_worker_->collect(wait);
  take(message::manager_rank, mail.rows);
  if (mail.farewell) farewell(message::manager_rank);
  const bool news = mail.farewell || !mail.rows.empty();
  if (news) supply(message::manager_rank);
  return news;
}

void Manager::take(int rank, const std::vector<Row>& rows) {
  worker_[rank].rows_out -= rows.size();
  for (const Row& row : rows) job_.finished(row);
}

void Manager::farewell(int rank) {
  worker_[rank].gone = true;
  --left_;
}

void Manager::supply(int rank) {
  Worker& worker = worker_[rank];
  while (!worker.dismissed && wants_chunk(worker)) {
    const auto rows = next_piece();
    if (!rows.empty()) {
      hand_out(rank, rows);
      continue;
    }
    // Who has nothing to do stays: its rank may still be asked to stop the others.
    if (std::ranges::all_of(worker_, [](const Worker& w) { return w.rows_out == 0; })) dismiss_all();
    return;
  }
}

bool Manager::wants_chunk(const Worker& worker) const {
  if (worker.rows_out == 0) return true;
  return worker.rows_out <= worker.last_chunk_rows && worker.last_chunk_seconds < prefetch_seconds;
}

std::span<const std::uint64_t> Manager::next_piece() {
  if (piece_.empty()) piece_ = job_.max_seconds ? schedule_.next(job_.max_seconds()) : schedule_.next();
  const auto rows = piece_.first(std::min(max_piece_rows, piece_.size()));
  piece_ = piece_.subspan(rows.size());
  return rows;
}

void Manager::hand_out(int rank, std::span<const std::uint64_t> rows) {
  std::vector<Tuple> tuples;
  tuples.reserve(rows.size());
  double seconds = 0.0;
  for (const std::uint64_t row : rows) {
    tuples.push_back({row, job_.tuple(row)});
    seconds += predicted_time(tuples.back().parameters);
  }
  Worker& worker = worker_[rank];
  worker.rows_out += rows.size();
  worker.last_chunk_rows = rows.size();
  worker.last_chunk_seconds = seconds;
  if (rank == message::manager_rank) return own_worker_->give(std::move(tuples));
  Sending& sending = sending_.emplace_back(std::move(tuples), boost::mpi::request());
  sending.request = message::send<Tuple>(workers_, rank, message::chunk, sending.tuples);
}

void Manager::dismiss(int rank) {
  worker_[rank].dismissed = true;
  if (rank == message::manager_rank) return own_worker_->say_quit();
  Sending& sending = sending_.emplace_back();
  sending.request = message::send<Tuple>(workers_, rank, message::quit, {});
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

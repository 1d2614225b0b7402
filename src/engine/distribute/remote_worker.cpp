#include "engine/distribute/remote_worker.hpp"

#include <boost/mpi/communicator.hpp>
#include <utility>

#include "engine/distribute/backoff.hpp"
#include "engine/distribute/messages.hpp"
#include "engine/distribute/task_queue.hpp"
#include "engine/distribute/worker.hpp"
#include "mpi/world_impl.hpp"

namespace sigmasweep {
namespace {

class RemoteConnection : public ManagerConnection {
 public:
  RemoteConnection(const boost::mpi::communicator& manager, const ByteJob& job)
      : manager_(manager), job_(job), queue_(job.task_size) {}

  Bytes next_batch() override {
    // Between the batches of a chunk nobody is in a hurry; work() looks for messages every millisecond.
    if (queue_.empty() || queue_.is_between_chunks())
      for (Backoff backoff; !quit() && queue_.empty(); backoff.sleep()) continue;
    if (quit_) return {};
    return queue_.take(job_.batch_size(queue_.first_chunk()));
  }

  void put_back(std::span<const std::byte> tasks) override { queue_.put_back(tasks); }

  bool is_between_chunks() override { return queue_.is_between_chunks(); }

  bool quit() override {
    while (!quit_) {
      const auto message = manager_.iprobe(message::manager_rank);
      if (!message) break;
      take(*message);
    }
    if (!quit_ && !asked_to_stop_ && job_.stop()) {
      asked_to_stop_ = true;
      send(message::stop, {});
    }
    return quit_;
  }

  bool expects_quit() override { return quit() || asked_to_stop_; }

  void deliver(Bytes answers) override { send(message::answers, std::move(answers)); }

  void deliver_last(Bytes answers) override {
    send(message::last_answers, std::move(answers));
    finish_sending();
  }

 private:
  void take(const boost::mpi::status& announced) {
    Bytes tasks = message::receive(manager_, announced);
    switch (announced.tag()) {
      case message::chunk: return queue_.add(std::move(tasks));
      case message::give_back: return give_back();
      case message::quit: quit_ = true; return;
      default: throw wire::BadMessage();
    }
  }

  void give_back() {
    Bytes number;
    wire::append(number, std::uint64_t{queue_.give_half()});
    send(message::given_back, std::move(number));
  }

  /// Returns at once, so that the next chunk can be computed meanwhile; one message at a time is under way.
  void send(message::Tag tag, Bytes bytes) {
    finish_sending();
    under_way_ = std::move(bytes);
    sending_ = message::send(manager_, message::manager_rank, tag, under_way_);
  }

  void finish_sending() {
    for (Backoff backoff; sending_.active() && !sending_.test(); backoff.sleep()) continue;
    sending_ = {};
  }

  const boost::mpi::communicator& manager_;
  const ByteJob& job_;
  TaskQueue queue_;
  Bytes under_way_;
  boost::mpi::request sending_;
  bool quit_ = false, asked_to_stop_ = false;
};

}  // namespace

void work_remotely(const World& world, const ByteJob& job) {
  RemoteConnection manager(world.impl().communicator, job);
  work(manager, job);
}

}  // namespace sigmasweep

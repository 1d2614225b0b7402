#include "engine/distribute/remote_worker.hpp"

#include <boost/mpi/communicator.hpp>
#include <deque>
#include <utility>

#include "engine/distribute/backoff.hpp"
#include "engine/distribute/messages.hpp"
#include "engine/distribute/worker.hpp"
#include "mpi/world_impl.hpp"

namespace sigmasweep {
namespace {

class RemoteConnection : public ManagerConnection {
 public:
  RemoteConnection(const boost::mpi::communicator& manager, const ByteJob& job) : manager_(manager), job_(job) {}

  Bytes next_chunk() override {
    for (Backoff backoff; !quit() && chunks_.empty(); backoff.sleep()) continue;
    if (quit_) return {};
    auto chunk = std::move(chunks_.front());
    chunks_.pop_front();
    return chunk;
  }

  bool quit() override {
    while (!quit_) {
      const auto message = manager_.iprobe(message::manager_rank);
      if (!message) break;
      Bytes tasks = message::receive(manager_, *message);
      if (message->tag() == message::quit)
        quit_ = true;
      else if (message->tag() == message::chunk && !tasks.empty())
        chunks_.push_back(std::move(tasks));
      else
        throw wire::BadMessage();
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
  std::deque<Bytes> chunks_;
  Bytes under_way_;
  boost::mpi::request sending_;
  bool quit_ = false, asked_to_stop_ = false;
};

}  // namespace

void work_remotely(const World& world, const ByteJob& job) {
  RemoteConnection manager(world.impl().communicator, job);
  work(manager, job.compute_first);
}

}  // namespace sigmasweep

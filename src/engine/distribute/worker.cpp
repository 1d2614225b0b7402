#include "engine/distribute/worker.hpp"

#include <boost/mpi/communicator.hpp>
#include <chrono>
#include <deque>
#include <utility>

#include "engine/distribute/backoff.hpp"
#include "engine/distribute/messages.hpp"
#include "mpi/world_impl.hpp"

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto look_every = std::chrono::milliseconds(1), deliver_every = std::chrono::milliseconds(200);
constexpr auto grace = std::chrono::milliseconds(500);  // mpirun kills a second after it has told us to stop

class RemoteLine : public Line {
 public:
  RemoteLine(const boost::mpi::communicator& manager, const Job& job) : manager_(manager), job_(job) {}

  std::vector<Tuple> next_chunk() override {
    for (Nap nap; !quit() && chunks_.empty(); nap.sleep()) continue;
    if (quit_) return {};
    auto chunk = std::move(chunks_.front());
    chunks_.pop_front();
    return chunk;
  }

  bool quit() override {
    while (!quit_) {
      const auto message = manager_.iprobe(message::manager_rank);
      if (!message) break;
      auto tuples = message::receive<Tuple>(manager_, *message);
      if (message->tag() == message::quit)
        quit_ = true;
      else
        chunks_.push_back(std::move(tuples));
    }
    if (!quit_ && !told_ && job_.stop()) {
      told_ = true;
      send(message::stop, {});
    }
    return quit_;
  }

  bool expects_quit() override { return quit() || told_; }

  void deliver(std::vector<Row> rows) override { send(message::rows, std::move(rows)); }

  void farewell(std::vector<Row> rows) override {
    send(message::farewell, std::move(rows));
    finish_sending();
  }

 private:
  /// Returns at once, so that the next chunk can be computed meanwhile; one message at a time is under way.
  void send(message::Tag tag, std::vector<Row> rows) {
    finish_sending();
    under_way_ = std::move(rows);
    sending_ = message::send<Row>(manager_, message::manager_rank, tag, under_way_);
  }

  void finish_sending() {
    for (Nap nap; sending_.active() && !sending_.test(); nap.sleep()) continue;
    sending_ = {};
  }

  const boost::mpi::communicator& manager_;
  const Job& job_;
  std::deque<std::vector<Tuple>> chunks_;
  std::vector<Row> under_way_;
  boost::mpi::request sending_;
  bool quit_ = false, told_ = false;
};

}  // namespace

void work(Line& line, const Compute& compute) {
  std::vector<Row> rows;
  std::optional<Clock::time_point> asked;
  const std::function<bool()> to_end = [&] {
    if (!asked && line.expects_quit()) asked = Clock::now();
    return asked && Clock::now() - *asked >= grace;
  };
  auto looked = Clock::now(), delivered = looked;
  const auto deliver = [&] {
    line.deliver(std::exchange(rows, {}));
    delivered = Clock::now();
  };
  bool quit = false;
  while (!quit) {
    const auto chunk = line.next_chunk();
    if (chunk.empty()) break;
    for (const Tuple& tuple : chunk) {
      const auto row = compute(tuple, to_end);
      if ((quit = !row)) break;
      rows.push_back(*row);
      const auto now = Clock::now();
      if (now - looked < look_every) continue;
      looked = now;
      if ((quit = line.quit())) break;
      if (now - delivered >= deliver_every) deliver();
    }
    if (!quit && !rows.empty()) deliver();
  }
  while (!line.next_chunk().empty()) continue;  // a tuple was dropped, and quit is still under way
  line.farewell(std::move(rows));
}

void work_remotely(const World& world, const Job& job) {
  RemoteLine line(world.impl().communicator, job);
  work(line, job.compute);
}

}  // namespace sigmasweep

#include "engine/distribute/worker.hpp"

#include <chrono>
#include <optional>
#include <utility>

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto look_every = std::chrono::milliseconds(1), deliver_every = std::chrono::milliseconds(200);
constexpr auto grace = std::chrono::milliseconds(500);  // mpirun kills a second after it has told the ranks to stop

}  // namespace

void work(ManagerConnection& manager, const ByteJob& job) {
  wire::Bytes answers;
  std::optional<Clock::time_point> asked;
  const std::function<bool()> should_end = [&] {
    if (!asked && manager.expects_quit()) asked = Clock::now();
    return asked && Clock::now() - *asked >= grace;
  };
  auto looked = Clock::now(), delivered = looked;
  for (bool quit = false; !quit;) {
    const wire::Bytes batch = manager.next_batch();
    if (batch.empty()) break;
    const std::size_t done = job.compute(batch, should_end, answers) * job.task_size;
    if (done < batch.size()) {
      manager.put_back(std::span(batch).subspan(done));
      if (should_end()) break;
    }
    const auto now = Clock::now();
    if (now - looked >= look_every) {
      looked = now;
      quit = manager.quit();
    }
    if (quit || answers.empty() || !(manager.is_between_chunks() || now - delivered >= deliver_every)) continue;
    manager.deliver(std::exchange(answers, {}));
    delivered = now;
  }
  while (!manager.next_batch().empty()) continue;  // a task was dropped, and quit is still under way
  manager.deliver_last(std::move(answers));
}

}  // namespace sigmasweep

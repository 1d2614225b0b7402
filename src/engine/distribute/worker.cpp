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

void work(ManagerConnection& manager, const decltype(ByteJob::compute_first)& compute_first) {
  wire::Bytes answers;
  std::optional<Clock::time_point> asked;
  const std::function<bool()> should_end = [&] {
    if (!asked && manager.expects_quit()) asked = Clock::now();
    return asked && Clock::now() - *asked >= grace;
  };
  auto looked = Clock::now(), delivered = looked;
  const auto deliver = [&] {
    manager.deliver(std::exchange(answers, {}));
    delivered = Clock::now();
  };
  bool quit = false;
  while (!quit) {
    const wire::Bytes chunk = manager.next_chunk();
    if (chunk.empty()) break;
    for (std::span<const std::byte> tasks(chunk); !tasks.empty();) {
      if ((quit = !compute_first(tasks, should_end, answers))) break;
      const auto now = Clock::now();
      if (now - looked < look_every) continue;
      looked = now;
      if ((quit = manager.quit())) break;
      if (now - delivered >= deliver_every) deliver();
    }
    if (!quit && !answers.empty()) deliver();
  }
  while (!manager.next_chunk().empty()) continue;  // a task was dropped, and quit is still under way
  manager.deliver_last(std::move(answers));
}

}  // namespace sigmasweep

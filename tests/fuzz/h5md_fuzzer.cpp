// Whatever the bytes of a trajectory: what was stored, or a refusal.
#include "store/h5md.hpp"

#include <cstdlib>

#include "fuzz/file_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sigmasweep;
  fuzz::read_file(data, size, [](const std::string& path) {
    const Trajectory t = read_h5md(path);
    if (t.z.size() != t.samples() * t.beads() || t.velocity.size() != t.z.size()) std::abort();
  });
  return 0;
}

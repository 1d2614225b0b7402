// Whatever the bytes of a precision study: what was stored, or a refusal.
#include "studies/precision/table.hpp"

#include "fuzz/file_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sigmasweep;
  fuzz::read_file(data, size, [](const std::string& path) {
    if (is_precision_table(path)) read_precision_table(path);
  });
  return 0;
}

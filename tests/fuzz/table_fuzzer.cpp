// Whatever the bytes of a table: what was stored, or a refusal.
#include "store/table/read.hpp"

#include <cstdlib>

#include "fuzz/file_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sigmasweep;
  fuzz::read_file(data, size, [](const std::string& path) {
    const Table table = read_table(path);
    for (const Row& row : table.rows)
      if (!table.info.slice.place(row.index)) std::abort();
  });
  return 0;
}

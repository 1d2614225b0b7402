// Whatever the bytes of a journal: rows of the sweep, each once, or a refusal that leaves the file alone. The header's
// checksum would keep nearly all inputs out, so half of them get a whole header and only their records are random.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "sigmasweep/base/errors.hpp"
#include "store/journal/journal.hpp"
#include "store/journal/record.hpp"
#include "support/store_samples.hpp"

namespace {

using namespace sigmasweep;
constexpr JournalIdentity identity{.spec_hash = 3, .physics_version = 1, .rows = 16};

/// The first byte of the input says how much of it is made good.
std::string journal_of(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 0) return bytes;
  const JournalHeader header = make_header(identity);
  const RecordCodec codec(header, record_fields(header, {}).value());
  std::string journal(reinterpret_cast<const char*>(&header), sizeof header);
  for (std::uint64_t i = 0; i < data[0] / 16u; ++i) {
    std::string record(codec.size(), '\0');
    codec.encode(samples::row(i), content_key(samples::row(i).parameters), i,
                 reinterpret_cast<std::byte*>(record.data()));
    journal += record;
  }
  return journal + bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const samples::Directory directory;
  static const std::string table = directory.file("t.h5"), path = table + ".journal";
  if (size == 0) return 0;
  const std::string bytes = journal_of(data, size);
  samples::put_bytes(path, bytes);
  try {
    const Journal journal(table, identity, false);
    std::uint64_t next = 0;
    for (const JournalledRow& row : journal.recovered()) {
      if (row.row.index < next || row.row.index >= identity.rows) std::abort();
      if (samples::bits(row) != samples::bits(samples::journalled(samples::row(row.row.index)))) std::abort();
      next = row.row.index + 1;
    }
  } catch (const OutputError&) {
    if (samples::bytes_of(path) != bytes) std::abort();
  }
  return 0;
}

// Journals that nobody wrote. Whatever the bytes are: no crash, no wrong row, and a file that is refused is untouched.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "sigmasweep/base/errors.hpp"
#include "store/journal/journal.hpp"
#include "store/journal/read.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using samples::bits;
using samples::bytes_of;
using samples::put_bytes;
using samples::row;

/// A row as a journal has it.
JournalledRow written(std::uint64_t index, std::uint64_t variant = 0) {
  return samples::journalled(row(index, variant));
}

constexpr JournalIdentity identity{.spec_hash = 3, .physics_version = 1, .rows = 16};

std::uint64_t seed() {
  const char* given = std::getenv("SIGMASWEEP_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 0) : std::random_device{}();
}

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}
  std::uint64_t below(std::uint64_t bound) {
    return std::uniform_int_distribution<std::uint64_t>(0, bound - 1)(random_);
  }

  std::string noise(std::size_t size) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(below(256));
    return bytes;
  }

  void mutate(std::string& bytes) {
    const std::size_t at = below(bytes.size() + 1), size = below(200);
    switch (below(7)) {
      case 0: bytes.resize(at); break;
      case 1: bytes += noise(size); break;
      case 2: bytes.insert(at, noise(size)); break;
      case 3: bytes.erase(at, size); break;
      case 4: bytes.replace(at, size, noise(size)); break;
      case 5: bytes.insert(at, bytes.substr(below(bytes.size() + 1), size)); break;
      default:
        if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
    }
  }

 private:
  std::mt19937_64 random_;
};

TEST(JournalFuzz, NeverCrashesNorInventsARow) {
  const std::uint64_t start = seed();
  std::printf("SIGMASWEEP_SEED=%llu\n", static_cast<unsigned long long>(start));
  Mutator mutator(start);
  const samples::Directory directory;
  const std::string table = directory.file("t.h5"), path = table + ".journal";
  {
    Journal journal(table, identity, true);
    for (std::uint64_t i = 0; i < identity.rows; ++i) journal.append(row(i));
  }
  const std::string whole = bytes_of(path);
  std::uint64_t description_size = 0;
  std::memcpy(&description_size, whole.data() + 48, sizeof description_size);
  const std::string head = whole.substr(0, 72 + description_size);
  std::uint64_t refused = 0, accepted = 0, found = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  while (std::chrono::steady_clock::now() < end) {
    std::string bytes = mutator.below(20) == 0 ? mutator.noise(mutator.below(5000)) : whole;
    if (mutator.below(10) == 0) bytes = head + mutator.noise(mutator.below(20000));
    for (auto times = 1 + mutator.below(4); times > 0; --times) mutator.mutate(bytes);
    put_bytes(path, bytes);
    std::uint64_t looked_at = 0;  // by a reader without a lock; a damaged description is no reason to lose rows
    try {
      const auto there = read_journal(table);
      for (const JournalledRow& r : there.value().rows) ASSERT_EQ(bits(r), bits(written(r.row.index)));
      looked_at = there->rows.size();
    } catch (const IoError&) {
    }
    try {
      const Journal journal(table, identity, false);
      ++accepted;
      const std::vector<JournalledRow> rows = journal.recovered();
      found += rows.size();
      ASSERT_LE(looked_at, rows.size());
      for (const JournalledRow& r : rows) {
        ASSERT_LT(r.row.index, identity.rows);
        ASSERT_EQ(bits(r), bits(written(r.row.index)));
      }
    } catch (const OutputError&) {
      ++refused;
      ASSERT_EQ(bytes_of(path), bytes);
    }
  }
  std::printf("%llu refused, %llu accepted with %llu rows\n", static_cast<unsigned long long>(refused),
              static_cast<unsigned long long>(accepted), static_cast<unsigned long long>(found));
  EXPECT_GT(refused, 0u);  // both ways were gone
  EXPECT_GT(found, 0u);
}

}  // namespace
}  // namespace sigmasweep

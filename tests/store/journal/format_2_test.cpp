// Journals of format 2, which earlier programs began: all parameters and all results in each record.
#include <gtest/gtest.h>
#include <xxhash.h>

#include <cstddef>
#include <cstring>
#include <string>

#include "model/packing.hpp"
#include "sigmasweep/model/physics_version.hpp"
#include "store/journal/journal.hpp"
#include "store/journal/read.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using samples::bits;
using samples::bytes_of;
using samples::put_bytes;

constexpr JournalIdentity identity{.spec_hash = 3, .physics_version = physics_version, .rows = 100};

std::vector<Field> fields_of_format_2() {
  std::vector<Field> fields;
  for (const auto list : {parameter_fields(), result_fields(), timing_fields()})
    fields.insert(fields.end(), list.begin(), list.end());
  return fields;
}

std::uint64_t layout_of(const std::vector<Field>& fields) {
  std::string layout;
  for (const Field& field : fields) {
    layout += std::string(field.name) + ":" + std::to_string(static_cast<int>(field.type.storage)) + ":";
    for (std::size_t i = 0; i < enumerators(field.type).size(); ++i)
      layout += (i > 0 ? "," : "") + std::string(enumerators(field.type)[i]);
    layout += ";";
  }
  return XXH3_64bits(layout.data(), layout.size());
}

template <class Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A journal of these rows.
std::string journal_of_format_2(const std::vector<Row>& rows) {
  const std::vector<Field> fields = fields_of_format_2();
  const std::string description =
      R"({"title":"old","start":"then","host":"node7","ranks":4,"slice":[0,1],"physics_version":)" +
      std::to_string(physics_version) + R"(,"build":"b","spec_hash":3,"spec":"[sweep]"})";
  JournalHeader header = make_header(identity, description);  // of the same build
  header.format_version = 2;
  header.record_size = static_cast<std::uint32_t>(packed_size(fields) + 24);
  header.layout = layout_of(fields);
  header.checksum = XXH3_64bits(&header, offsetof(JournalHeader, checksum));
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes += description;
  for (std::uint64_t number = 0; const Row& row : rows) {
    std::string record;
    append(record, row.index);
    append(record, content_key(row.parameters));
    std::vector<std::byte> packed(packed_size(fields));
    pack(fields, row, packed.data());
    record.append(reinterpret_cast<const char*>(packed.data()), packed.size());
    append(record, XXH3_64bits_withSeed(record.data(), record.size(), header.checksum + number++));
    bytes += record;
  }
  return bytes;
}

class JournalOfFormat2 : public testing::Test {
 protected:
  void expect_rows(const std::vector<JournalledRow>& found) const {
    ASSERT_EQ(found.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(bits(found[k]), bits(samples::journalled(rows[k])));
  }
  samples::Directory directory;
  const std::vector<Row> rows = samples::rows(10, 20);
  std::string table = directory.file("t.h5"), path = directory.file("t.h5.journal");
};

TEST_F(JournalOfFormat2, IsRead) {
  put_bytes(path, journal_of_format_2(rows));
  const auto found = read_journal(table);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->info.title, "old");
  expect_rows(found->rows);
}

TEST_F(JournalOfFormat2, IsRewrittenAndContinued) {
  const std::string old = journal_of_format_2(rows);
  put_bytes(path, old + old.substr(100, 50));  // torn
  std::uint64_t visited = 0;
  {
    Journal journal(table, identity, false, {}, {}, [&](const JournalledRow&) { ++visited; });
    EXPECT_EQ(journal.dropped(), 1u);
    journal.append(samples::row(40));
  }
  EXPECT_EQ(visited, rows.size());
  EXPECT_LT(bytes_of(path).size(), old.size());
  const std::vector<JournalledRow> found = Journal(table, identity, false).recovered();
  ASSERT_EQ(found.size(), rows.size() + 1);
  EXPECT_EQ(bits(found.back()), bits(samples::journalled(samples::row(40))));
}

}  // namespace
}  // namespace sigmasweep

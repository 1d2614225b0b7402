// read_table without MPI, on files made here by plain HDF5 calls: what others may have written, changed or broken.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/names.hpp"
#include "store/table/checksum.hpp"
#include "store/table/read.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep {
namespace {

using samples::message_of;

/// A member of a compound: name, type, and its value in row k as it goes into the file.
struct Member {
  std::string name;
  hid_t type;
  std::function<std::string(int k)> bytes;
};

template <class T>
Member number(const std::string& name, hid_t type, const std::function<T(int)>& value) {
  return {name, type, [value](int k) {
            const T v = value(k);
            return std::string(reinterpret_cast<const char*>(&v), sizeof v);
          }};
}

hid_t enumeration(const std::vector<std::string>& names, int first = 0) {
  const hid_t type = H5Tenum_create(H5T_NATIVE_UINT8);
  auto value = static_cast<std::uint8_t>(first);
  for (const auto& name : names) {
    EXPECT_GE(H5Tenum_insert(type, name.c_str(), &value), 0);
    ++value;
  }
  return type;
}

/// Makes a table file; the parts can be changed before make().
struct Maker {
  int rows = 3;
  std::uint64_t checksum_error = 0;
  std::map<std::string, std::string> texts{
      {"format", "sigmasweep-table"},    {"title", "t"},    {"spec", "s"},
      {"spec_hash", "00000000000000ff"}, {"host", "h"},     {"start", "now"},
      {"program_version", "0"},          {"compiler", "c"}, {"compiler_flags", "-O"}};
  std::map<std::string, std::uint64_t> numbers{
      {"format_version", 2}, {"physics_version", 5}, {"rows", 3}, {"ranks", 2}};
  std::map<std::string, std::vector<Member>> datasets{
      {"results", {number<double>("v0", H5T_NATIVE_DOUBLE, [](int k) { return k + 0.5; })}},
      {"timings", {number<double>("run_time", H5T_NATIVE_DOUBLE, [](int k) { return k + 0.25; })}}};

  void make(const std::string& path) const {
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    const hid_t scalar = H5Screate(H5S_SCALAR);
    for (const auto& [name, text] : texts) put_text(file, name, text);
    for (const auto& [name, value] : numbers) {
      const hid_t a = H5Acreate2(file, name.c_str(), H5T_NATIVE_UINT64, scalar, H5P_DEFAULT, H5P_DEFAULT);
      ASSERT_GE(H5Awrite(a, H5T_NATIVE_UINT64, &value), 0);
      H5Aclose(a);
    }
    for (const auto& [name, members] : datasets) dataset(file, name, members);
    H5Sclose(scalar);
    ASSERT_GE(H5Fclose(file), 0);
  }

 private:
  static void put_text(hid_t object, const std::string& name, const std::string& text) {
    const hid_t scalar = H5Screate(H5S_SCALAR), type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    const hid_t a = H5Acreate2(object, name.c_str(), type, scalar, H5P_DEFAULT, H5P_DEFAULT);
    const char* characters = text.c_str();
    ASSERT_GE(H5Awrite(a, type, &characters), 0);
    H5Aclose(a);
    H5Tclose(type);
    H5Sclose(scalar);
  }

  void dataset(hid_t file, const std::string& name, const std::vector<Member>& members) const {
    std::size_t size = 0;
    for (const Member& m : members) size += H5Tget_size(m.type);
    const hid_t type = H5Tcreate(H5T_COMPOUND, size);
    std::size_t offset = 0;
    for (const Member& m : members) {
      ASSERT_GE(H5Tinsert(type, m.name.c_str(), offset, m.type), 0);
      offset += H5Tget_size(m.type);
    }
    std::string bytes;
    for (int k = 0; k < rows; ++k)
      for (const Member& m : members) bytes += m.bytes(k);
    const hsize_t extent = static_cast<hsize_t>(rows);
    const hid_t space = H5Screate_simple(1, &extent, nullptr);
    const hid_t set = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    ASSERT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), 0);
    const auto count = static_cast<std::uint64_t>(rows);
    write_checksum(set, checksum_of_layout(type) + checksum_of_stored_rows(set, 0, count) + checksum_error);
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
  }
};

class TableReadTest : public testing::Test {
 protected:
  samples::Directory directory;
  std::string path = directory.file("t.h5");
  Maker maker;

  std::string refusal() {
    maker.make(path);
    const std::string message = message_of<IoError>([&] { read_table(path); });
    EXPECT_NE(message.find(path), std::string::npos) << message;
    return message;
  }
};

TEST_F(TableReadTest, ReadsAPlainTable) {
  maker.make(path);
  const Table table = read_table(path);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[2].index, 2u);
  EXPECT_EQ(table.rows[2].parameters.v0, 2.5);
  EXPECT_EQ(table.rows[2].timing.run_time, 2.25);
  EXPECT_EQ(table.rows[2].parameters.N, Parameters().N);
  EXPECT_TRUE(std::isnan(table.rows[2].result.eps_eff));
  ASSERT_EQ(table.columns.size(), 1u);
  EXPECT_EQ(table.columns[0].name, "v0");
  EXPECT_EQ(table.info.spec_hash, 255u);
  EXPECT_EQ(table.info.ranks, 2);
  EXPECT_EQ(table.info.physics_version, 5u);
}

TEST_F(TableReadTest, PassesOverMembersThatItDoesNotKnow) {
  auto& results = maker.datasets["results"];
  results.insert(results.begin(), number<double>("pressure", H5T_NATIVE_DOUBLE, [](int) { return 9.0; }));
  results.push_back(number<float>("run_time", H5T_NATIVE_FLOAT, [](int) { return 9.0f; }));  // known, but not there
  results.push_back(number<std::int64_t>("N", H5T_NATIVE_INT64, [](int k) { return 10 + k; }));
  maker.make(path);
  const Table table = read_table(path);
  ASSERT_EQ(table.columns.size(), 2u);
  EXPECT_EQ(table.columns[1].name, "N");
  EXPECT_EQ(table.rows[1].parameters.v0, 1.5);
  EXPECT_EQ(table.rows[1].parameters.N, 11);
  EXPECT_EQ(table.rows[1].timing.run_time, 1.25);
}

TEST_F(TableReadTest, ConvertsOtherSizesAndByteOrders) {
  maker.datasets["results"] = {
      number<float>("v0", H5T_IEEE_F32LE, [](int k) { return 0.5f * static_cast<float>(k); }),
      number<std::uint32_t>("N", H5T_STD_U32BE, [](int k) { return __builtin_bswap32(static_cast<unsigned>(k + 7)); })};
  maker.make(path);
  const Table table = read_table(path);
  EXPECT_EQ(table.rows[2].parameters.v0, 1.0);
  EXPECT_EQ(table.rows[2].parameters.N, 9);
}

TEST_F(TableReadTest, ReadsEnumerationsByName) {  // another order of the names means other numbers
  maker.datasets["results"].push_back(
      number<std::uint8_t>("method", enumeration({"ed", "md"}), [](int k) -> std::uint8_t { return k == 1; }));
  maker.make(path);
  const Table table = read_table(path);
  EXPECT_EQ(table.rows[0].parameters.method, Method::ed);
  EXPECT_EQ(table.rows[1].parameters.method, Method::md);
}

TEST_F(TableReadTest, RefusesANameThatIsNoneOfItsOwn) {
  maker.datasets["results"].push_back(
      number<std::uint8_t>("method", enumeration({"md", "ed", "xd"}), [](int k) -> std::uint8_t { return k == 1; }));
  refusal();
}

TEST_F(TableReadTest, RefusesAMemberOfAnotherType) {
  auto& results = maker.datasets["results"];
  results.push_back(number<double>("N", H5T_NATIVE_DOUBLE, [](int) { return 10.0; }));
  EXPECT_NE(refusal().find("member N"), std::string::npos);
  results.back() = number<std::uint8_t>("status", H5T_NATIVE_UINT8, [](int) { return std::uint8_t{0}; });
  EXPECT_NE(refusal().find("member status"), std::string::npos);
  results.back() = number<std::int32_t>("tc", H5T_NATIVE_INT32, [](int) { return 1; });
  EXPECT_NE(refusal().find("member tc"), std::string::npos);
}

TEST_F(TableReadTest, RefusesAFileThatIsNoTable) {
  EXPECT_THROW(read_table(path), InputNotFound);
  EXPECT_THROW(read_table(path + "/t.h5"), InputNotFound);
  EXPECT_THROW(read_table(directory.file("")), IoError);  // a directory
  for (const std::string& bytes : {std::string(), std::string("hello"), std::string(10'000, 'x')}) {
    samples::put_bytes(path, bytes);
    EXPECT_NE(message_of<IoError>([&] { read_table(path); }).find(path), std::string::npos);
  }
}

TEST_F(TableReadTest, RefusesAnHdf5FileThatIsNoTable) {
  maker.texts["format"] = "sigmasweep-study";
  EXPECT_NE(refusal().find("format"), std::string::npos);
  maker.texts.erase("format");
  EXPECT_NE(refusal().find("format"), std::string::npos);
  maker.texts.clear(), maker.numbers.clear(), maker.datasets.clear();
  refusal();
}

TEST_F(TableReadTest, RefusesAnotherVersion) {
  maker.numbers["format_version"] = 1;
  EXPECT_NE(refusal().find("version 1"), std::string::npos);
}

TEST_F(TableReadTest, RefusesRowsWithoutTheirChecksum) {
  maker.checksum_error = 1;
  EXPECT_NE(refusal().find("checksum"), std::string::npos);
}

TEST_F(TableReadTest, RefusesATableWithAPartMissing) {
  for (const char* name : {"title", "spec", "spec_hash", "host", "start"}) {
    maker = Maker();
    maker.texts.erase(name);
    EXPECT_NE(refusal().find(name), std::string::npos);
  }
  for (const char* name : {"format_version", "physics_version", "rows", "ranks"}) {
    maker = Maker();
    maker.numbers.erase(name);
    EXPECT_NE(refusal().find(name), std::string::npos);
  }
  for (const char* name : {"results", "timings"}) {
    maker = Maker();
    maker.datasets.erase(name);
    EXPECT_NE(refusal().find(name), std::string::npos);
  }
}

TEST_F(TableReadTest, RefusesAnotherNumberOfRowsHoweverLarge) {
  for (const std::uint64_t rows : {std::uint64_t{2}, std::uint64_t{4}, std::uint64_t{1} << 60, ~std::uint64_t{0}}) {
    maker.numbers["rows"] = rows;
    refusal();
  }
}

TEST_F(TableReadTest, RefusesAHashThatIsNone) {
  maker.texts["spec_hash"] = "0xff";
  EXPECT_NE(refusal().find("spec_hash"), std::string::npos);
}

}  // namespace
}  // namespace sigmasweep

#include "store/table/info.hpp"

#include <fmt/format.h>

#include <utility>

#include "sigmasweep/model/physics_version.hpp"
#include "store/build_info.hpp"
#include "store/hdf5/attributes.hpp"
#include "store/hdf5/long_text.hpp"
#include "store/library_versions.hpp"
#include "store/table/checksum.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {

TableInfo common_info(const RankGroup& group, TableInfo info) {
  for (std::string* text : {&info.title, &info.spec_text, &info.host, &info.start})
    *text = group.broadcast(std::move(*text));
  info.spec_hash = group.broadcast(info.spec_hash);
  info.ranks = static_cast<int>(group.broadcast(static_cast<std::uint64_t>(info.ranks)));
  return info;
}

void write_info(hid_t file, const char* format, std::uint64_t format_version, const TableInfo& info,
                std::uint64_t rows) {
  write_text(file, "format", format);
  write_number(file, "format_version", format_version);
  create_long_text(file, "title", info.title);
  create_long_text(file, "spec", info.spec_text);
  write_text(file, "spec_hash", fmt::format("{:016x}", info.spec_hash));
  write_number(file, "physics_version", physics_version);
  write_number(file, "rows", rows);
  write_text(file, "program_version", build_info().program_version);
  write_text(file, "git_revision", build_info().git_revision);
  write_text(file, "compiler", build_info().compiler);
  write_text(file, "compiler_flags", build_info().compiler_flags);
  write_text(file, "mpi_version", mpi_version());
  write_text(file, "hdf5_version", hdf5_version());
  write_text(file, "host", info.host);
  write_text(file, "start", info.start);
  write_number(file, "ranks", static_cast<std::uint64_t>(info.ranks));
  if (info.slice.is_whole()) return;
  write_number(file, "slice_index", info.slice.index);
  write_number(file, "slice_count", info.slice.count);
}

void write_long_texts(hid_t file, const TableInfo& info) {
  fill_long_text(file, "title", info.title);
  fill_long_text(file, "spec", info.spec_text);
}

StoredInfo read_info(hid_t file) {
  if (H5Aexists(file, "format") <= 0 || read_text(file, "format") != table_format)
    throw IoError(fmt::format("its attribute format is not {}", table_format));
  if (const auto version = read_number(file, "format_version"); version != table_format_version)
    throw IoError(fmt::format("it has format version {}, this program reads {}", version, table_format_version));
  StoredInfo stored;
  stored.rows = read_number(file, "rows");
  TableInfo& info = stored.info;
  info.title = read_long_text(file, "title");
  info.spec_text = read_long_text(file, "spec");
  info.spec_hash = parse_hexadecimal(read_text(file, "spec_hash"), "spec_hash");
  info.host = read_text(file, "host");
  info.start = read_text(file, "start");
  info.ranks = static_cast<int>(read_number(file, "ranks"));
  info.physics_version = static_cast<std::uint32_t>(read_number(file, "physics_version"));
  info.build = fmt::format("{}\n{}\n{}", read_text(file, "program_version"), read_text(file, "compiler"),
                           read_text(file, "compiler_flags"));
  if (H5Aexists(file, "slice_count") > 0)
    info.slice = {read_number(file, "slice_index"), read_number(file, "slice_count")};
  if (info.slice.index >= info.slice.count) throw IoError("it is a slice of no sweep");
  return stored;
}

}  // namespace sigmasweep

#include "store/hdf5/open.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <span>
#include <vector>

#include "base/file.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/seal.hpp"

namespace sigmasweep {
namespace {

Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose, "cannot make a property list"}; }

/// Without waiting: open(2) of a FIFO would wait for a writer.
File open_regular(const std::string& path, const char* noun) {
  File file(path, O_RDONLY | O_NONBLOCK);
  if (!file.is_open() && (errno == ENOENT || errno == ENOTDIR))
    throw InputNotFound(fmt::format("there is no {} {}", noun, path));
  struct stat status {};
  if (!file.is_open() || ::fstat(file.fd(), &status) != 0) throw IoError(fmt::format("cannot open: {}", reason(errno)));
  if (!S_ISREG(status.st_mode)) throw IoError("it is not a regular file");
  return file;
}

/// HDF5 refuses a file of its format 3 that is noted as open for writing. As h5clear does, but on a copy in memory, the
/// note is cleared (the property is not documented; it is that of h5clear).
Handle open_in_memory(const File& file, const std::string& path) {
  const char* const what = "cannot open";
  struct stat status {};
  if (::fstat(file.fd(), &status) != 0) throw IoError(fmt::format("{}: {}", what, reason(errno)));
  std::vector<std::byte> image(static_cast<std::size_t>(status.st_size));
  image.resize(read_at(file.fd(), image, 0, path));
  const Handle access = property_list(H5P_FILE_ACCESS);
  constexpr std::size_t growth = std::size_t{1} << 16;
  const hbool_t clear = true;
  check(H5Pset_fapl_core(access, growth, /*backing_store=*/false), what);
  check(H5Pset_file_image(access, image.data(), image.size()), what);
  check(H5Pset(access, "clear_status_flags", &clear), what);
  return {H5Fopen("in memory", H5F_ACC_RDWR, access), H5Fclose, what};
}

/// Throws IoError if a part of the path is a link to elsewhere.
void require_own(hid_t parent, const std::string& path) {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string so_far = path.substr(0, end);
    H5L_info_t link{};
    check(H5Lget_info(parent, so_far.c_str(), &link, H5P_DEFAULT), "it has no " + path);
    if (link.type != H5L_TYPE_HARD) throw IoError(fmt::format("{} is a link to elsewhere", so_far));
  }
}

}  // namespace

Handle open_unsealed(const std::string& path) {
  const Handle access = property_list(H5P_FILE_ACCESS);
  // No locks: a table never changes once it is there, and some shared file systems have none.
  check(H5Pset_file_locking(access, false, true), "cannot switch off file locking");
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "cannot open"};
}

Handle open_file(const std::string& path, const char* noun) {
  const File file = open_regular(path, noun);
  check_seal(file, path);
  try {
    return open_unsealed(path);
  } catch (const IoError&) {
    if (!is_noted_as_open(file, path)) throw;
    return open_in_memory(file, path);
  }
}

Handle open_group(hid_t parent, const std::string& path) {
  require_own(parent, path);
  return {H5Gopen2(parent, path.c_str(), H5P_DEFAULT), H5Gclose, "cannot open group " + path};
}

Handle open_dataset(hid_t parent, const std::string& path) {
  const std::string what = "cannot read dataset " + path;
  require_own(parent, path);
  Handle dataset(H5Dopen2(parent, path.c_str(), H5P_DEFAULT), H5Dclose, what);
  const Handle creation(H5Dget_create_plist(dataset), H5Pclose, what);
  if (H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) != 0)
    throw IoError(fmt::format("the data of {} are in other files", path));
  return dataset;
}

void require_stored(hid_t dataset, std::uint64_t count, std::uint64_t size) {
  // zlib packs at most 1032 to 1; other filters of HDF5 less.
  constexpr std::uint64_t best_packing = 1032, largest_chunk = std::uint64_t{1} << 30;
  constexpr std::uint64_t largest_element = std::uint64_t{1} << 16;
  constexpr int most_dimensions = 8;
  const char* const wrong = "a dataset has not the size that it should have";
  const Handle creation(H5Dget_create_plist(dataset), H5Pclose, wrong);
  std::uint64_t stored = H5Dget_storage_size(dataset);
  if (H5Pget_layout(creation) == H5D_CHUNKED) {
    std::array<hsize_t, most_dimensions> extents{};
    const int dimensions = H5Pget_chunk(creation, most_dimensions, extents.data());
    if (dimensions < 1 || dimensions > most_dimensions) throw IoError(wrong);
    std::uint64_t chunk = size;
    for (const hsize_t extent : std::span(extents).first(static_cast<std::size_t>(dimensions)))
      chunk = extent > largest_chunk ? largest_chunk + 1 : std::min<std::uint64_t>(chunk * extent, largest_chunk + 1);
    if (chunk > largest_chunk) throw IoError("a dataset has chunks that are too large");
    if (H5Pget_nfilters(creation) > 0) stored = std::min<std::uint64_t>(stored, std::uint64_t{1} << 53) * best_packing;
  }
  if (size == 0 || size > largest_element || count > stored / size) throw IoError(wrong);
}

}  // namespace sigmasweep

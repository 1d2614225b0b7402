#include "store/table/place.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "base/file.hpp"
#include "base/output/place.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/seal.hpp"

namespace sigmasweep {
namespace {

constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
/// Root attributes stand near the beginning, or behind the rows where a file was changed.
constexpr std::uint64_t looked_at = std::uint64_t{8} << 20;

std::string bytes_of(const File& file, std::uint64_t first, std::uint64_t count, const std::string& path) {
  std::string bytes(count, '\0');
  bytes.resize(read_at(file.fd(), std::as_writable_bytes(std::span(bytes)), first, path));
  return bytes;
}

}  // namespace

bool is_file_of_ours(const std::string& path, const std::string& format) {
  const File file(path, O_RDONLY | O_NONBLOCK);
  struct stat status {};
  if (!file.is_open() || ::fstat(file.fd(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size == 0) return true;
  const std::string head = bytes_of(file, 0, std::min(size, looked_at), path);
  if (!head.starts_with(hdf5_signature) && !has_seal(file)) return false;
  if (head.find(format) != std::string::npos) return true;
  const std::uint64_t tail = size - std::min(size, looked_at);
  return tail > 0 && bytes_of(file, tail, looked_at, path).find(format) != std::string::npos;
}

void require_place_for_table(const std::string& path, std::span<const std::string> inputs, const std::string& format) {
  require_file_place(path, "a table needs a file");
  require_other_file(path, inputs);
  if (std::filesystem::exists(path) && !is_file_of_ours(path, format))
    throw OutputError(
        fmt::format("{}: is there already and is not a whole {}; nothing was changed. Remove it, or choose another "
                    "output with -o",
                    path, format == table_format ? "sigmasweep table" : format + " table"));
}

}  // namespace sigmasweep

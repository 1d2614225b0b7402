#include "model/packing.hpp"

#include <cstring>
#include <type_traits>

namespace sigmasweep {
namespace {

static_assert(std::is_trivially_copyable_v<Row>);

}  // namespace

std::size_t packed_size(FieldType type) {
  switch (type.storage) {
    case FieldType::Storage::real:
    case FieldType::Storage::integer:
    case FieldType::Storage::unsigned_integer: return 8;
    case FieldType::Storage::integer32: return 4;
    case FieldType::Storage::enumeration: break;
  }
  return 1;
}

std::size_t packed_size(std::span<const Field> fields) {
  std::size_t size = 0;
  for (const Field& field : fields) size += packed_size(field.type);
  return size;
}

void pack(std::span<const Field> fields, const Row& row, std::byte* out) {
  const auto* from = reinterpret_cast<const std::byte*>(&row);
  for (const Field& field : fields) {
    const std::size_t size = packed_size(field.type);
    std::memcpy(out, from + field.offset, size);
    out += size;
  }
}

bool unpack(std::span<const Field> fields, const std::byte* in, Row& row) {
  auto* to = reinterpret_cast<std::byte*>(&row);
  for (const Field& field : fields) {
    const std::size_t size = packed_size(field.type);
    const std::size_t names = enumerators(field.type).size();
    if (names != 0 && std::to_integer<std::size_t>(*in) >= names) return false;
    std::memcpy(to + field.offset, in, size);
    in += size;
  }
  return true;
}

}  // namespace sigmasweep

#include "store/table/types.hpp"

#include <cstdint>
#include <string_view>

#include "model/packing.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

const char* const what = "cannot make a data type";

Handle number_type(hid_t native) { return {H5Tcopy(native), H5Tclose, what}; }

Handle enum_type(std::span<const std::string_view> names) {
  Handle type(H5Tenum_create(H5T_NATIVE_UINT8), H5Tclose, what);
  std::uint8_t value = 0;
  for (const std::string_view name : names) {
    check(H5Tenum_insert(type, std::string(name).c_str(), &value), what);
    ++value;
  }
  return type;
}

/// h5py and PyTables read this enumeration as bool.
Handle flag_type() {
  Handle type(H5Tenum_create(H5T_NATIVE_INT8), H5Tclose, what);
  std::int8_t value = 0;
  for (const std::string_view name : flag_names) {
    check(H5Tenum_insert(type, std::string(name).c_str(), &value), what);
    ++value;
  }
  return type;
}

}  // namespace

Handle value_type(FieldType type) {
  switch (type.storage) {
    case FieldType::Storage::real: return number_type(H5T_NATIVE_DOUBLE);
    case FieldType::Storage::integer: return number_type(H5T_NATIVE_INT64);
    case FieldType::Storage::unsigned_integer: return number_type(H5T_NATIVE_UINT64);
    case FieldType::Storage::integer32: return number_type(H5T_NATIVE_INT32);
    case FieldType::Storage::enumeration: break;
  }
  return type == FieldType::of<Flag>() ? flag_type() : enum_type(enumerators(type));
}

Handle packed_type(std::span<const Field> fields, bool of_earlier_program) {
  Handle type(H5Tcreate(H5T_COMPOUND, packed_size(fields)), H5Tclose, what);
  std::size_t offset = 0;
  for (const Field& field : fields) {
    check(H5Tinsert(type, std::string(field.name).c_str(), offset,
                    of_earlier_program && field.type == FieldType::of<Flag>() ? enum_type(enumerators(field.type))
                                                                              : value_type(field.type)),
          what);
    offset += packed_size(field.type);
  }
  return type;
}

std::string member_name(hid_t type, unsigned i) {
  char* text = H5Tget_member_name(type, i);
  if (text == nullptr) throw IoError("a member has no name");
  std::string name = text;
  check(H5free_memory(text), "cannot free memory");
  return name;
}

}  // namespace sigmasweep

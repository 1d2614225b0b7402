#pragma once

#include <cstdint>
#include <limits>

#include "sigmasweep/model/fields.hpp"

/// Values of fields as numbers, 64-bit integers to the bit. number() rounds whole numbers beyond 2^53.
namespace sigmasweep {

/// A number that holds every double and every 64-bit integer.
using AnyNumber = long double;
static_assert(std::numeric_limits<AnyNumber>::digits >= 64);

/// The value of a field; for an enumerator its number.
template <class Owner>
AnyNumber exact_number(const FieldOf<Owner>& field, const Owner& owner) {
  const auto* member = reinterpret_cast<const std::byte*>(&owner) + field.offset;
  if (field.type == FieldType::integer) return *reinterpret_cast<const std::int64_t*>(member);
  if (field.type == FieldType::unsigned_integer) return *reinterpret_cast<const std::uint64_t*>(member);
  return number(field, owner);
}

/// Sets the value of a field from an exact_number(), which must be whole for an integer, and that of an enumerator for
/// an enumeration.
template <class Owner>
void set_exact_number(const FieldOf<Owner>& field, Owner& owner, AnyNumber value) {
  auto* member = reinterpret_cast<std::byte*>(&owner) + field.offset;
  if (field.type == FieldType::integer)
    *reinterpret_cast<std::int64_t*>(member) = static_cast<std::int64_t>(value);
  else
    set_number(field, owner, static_cast<double>(value));
}

}  // namespace sigmasweep

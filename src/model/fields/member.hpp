#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "sigmasweep/model/fields.hpp"

/// Name, type and place of a field, from the member that it is: the beginning of each row of the tables of fields.
#define SIGMASWEEP_MEMBER(Owner, member) SIGMASWEEP_MEMBER_NAMED(#member, Owner, member)
#define SIGMASWEEP_MEMBER_NAMED(called, Owner, member)                                                         \
  .name = called, .type = FieldType::of<std::remove_cvref_t<decltype(std::declval<const Owner&>().member)>>(), \
  .offset = offsetof(Owner, member)

#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "sigmasweep/model/fields.hpp"

namespace sigmasweep {

/// Field names and values: numbers to the bit (null where there is none), enumerators by name,
/// true and false.
nlohmann::ordered_json json_of(std::span<const Field> fields, const Row& row);

}  // namespace sigmasweep

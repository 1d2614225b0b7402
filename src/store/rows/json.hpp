#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "sigmasweep/model/fields.hpp"

namespace sigmasweep {

/// A row as a JSON object of field names and values: numbers to the bit, null for one that is missing, enumerators by
/// name, flags as true and false.
nlohmann::ordered_json json_of(std::span<const Field> fields, const Row& row);

}  // namespace sigmasweep

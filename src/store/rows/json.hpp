#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "sigmasweep/model/fields.hpp"

namespace sigmasweep {

/// A row as a JSON object of field names and values: numbers to the bit, null for one that is missing, enumerators by
/// name, flags as true and false.
nlohmann::ordered_json json_of(std::span<const Field> fields, const Row& row);

/// How many rows have each status: an object of names and numbers; statuses without a row are left out.
nlohmann::ordered_json counts_by_status(std::span<const Row> rows);

}  // namespace sigmasweep

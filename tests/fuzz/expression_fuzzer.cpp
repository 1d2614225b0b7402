// Whatever the bytes: a condition or a formula that can be computed, or a UsageError.
#include <cstdint>
#include <string>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sweep/expression/formula.hpp"
#include "sweep/expression/where.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sigmasweep;
  static const std::vector<Field> fields = [] {
    std::vector<Field> all;
    for (const auto list : {parameter_fields(), result_fields()}) all.insert(all.end(), list.begin(), list.end());
    return all;
  }();
  const std::string text(reinterpret_cast<const char*>(data), size);
  Row row;
  row.parameters.sigma = 0.5;
  row.parameters.N = 3;
  try {
    Where where(text, fields);
    where(row);
  } catch (const UsageError&) {
  }
  try {
    Formula formula(text, fields);
    formula(row);
    (void)formula.used();
  } catch (const UsageError&) {
  }
  return 0;
}

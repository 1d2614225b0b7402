// Whatever the bytes: a sweep of valid rows or a SpecError that names the file.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "studies/sections.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sigmasweep;
  try {
    const Sweep sweep = Sweep::parse({reinterpret_cast<const char*>(data), size}, "fuzz.toml", study_sections);
    if (sweep.size() == 0) std::abort();
    for (const std::uint64_t row : {std::uint64_t{0}, sweep.size() / 2, sweep.size() - 1})
      if (!why_invalid(sweep.at(row)).empty()) std::abort();
  } catch (const SpecError& error) {
    if (!std::string(error.what()).starts_with("fuzz.toml:")) std::abort();
  }
  return 0;
}

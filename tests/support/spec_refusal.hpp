#pragma once

#include <string>

#include <gtest/gtest.h>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "studies/sections.hpp"

/// What a spec is refused with.
namespace sigmasweep {

/// The message, or "accepted".
inline std::string refusal_of(const std::string& spec, const std::string& file) {
  try {
    Sweep::parse(spec, file, study_sections);
  } catch (const SpecError& error) {
    return error.what();
  }
  return "accepted";
}

inline void expect_part(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message << "\n  lacks: " << part;
}

}  // namespace sigmasweep

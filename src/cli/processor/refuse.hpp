#pragma once

namespace sigmasweep {

/// Instructions that this processor has.
struct Instructions {
  bool v3 = false;      ///< of x86-64-v3: AVX2, FMA, BMI2, ...
  bool avx512 = false;  ///< of x86-64-v4
};

/// What to tell somebody whose processor cannot run this build; null: it can.
const char* why_not_on(const Instructions& there, bool built_for_avx512);

}  // namespace sigmasweep

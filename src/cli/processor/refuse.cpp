#include "cli/processor/refuse.hpp"

#include <unistd.h>

#include <cstring>

#include "base/exit_codes.hpp"
#include "cli/processor/built_for.hpp"

// Compiled for the oldest processors: this is all that runs before it is known which one is there.
namespace sigmasweep {
namespace {

Instructions present() {
  __builtin_cpu_init();
  const auto has = [](int answer) { return answer != 0; };
  return {.v3 = has(__builtin_cpu_supports("avx2")) && has(__builtin_cpu_supports("fma")) &&
                has(__builtin_cpu_supports("bmi")) && has(__builtin_cpu_supports("bmi2")),
          .avx512 = has(__builtin_cpu_supports("avx512f")) && has(__builtin_cpu_supports("avx512bw")) &&
                    has(__builtin_cpu_supports("avx512cd")) && has(__builtin_cpu_supports("avx512dq")) &&
                    has(__builtin_cpu_supports("avx512vl"))};
}

/// Before all other initialisation, which may need the instructions. Nothing is called that other sources may have
/// compiled.
[[gnu::constructor(101)]] void refuse_old_processors() {
  const char* const why = why_not_on(present(), built_for_avx512);
  if (!why) return;
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, why, std::strlen(why));
  ::_exit(exit_code::unavailable);
}

}  // namespace

const char* why_not_on(const Instructions& there, bool for_avx512) {
  if (!there.v3)
    return "sigmasweep: this processor lacks AVX2, FMA or BMI2, which sigmasweep needs (x86-64-v3: Intel since "
           "Haswell, AMD since Zen)\n";
  if (for_avx512 && !there.avx512)
    return "sigmasweep: this program was built for processors with AVX-512 only; build it with "
           "-DSIGMASWEEP_ARCH=x86-64-v3\n";
  return nullptr;
}

}  // namespace sigmasweep

#include "base/standard_error.hpp"

#include <cstdio>

namespace sigmasweep {

void print_on_stderr(std::string_view text) noexcept {
  if (std::fwrite(text.data(), 1, text.size(), stderr) != text.size() || std::fflush(stderr) != 0)
    std::clearerr(stderr);
}

}  // namespace sigmasweep

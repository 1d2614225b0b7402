#include "cli/complain.hpp"

#include <fmt/format.h>

#include "base/standard_error.hpp"
#include "cli/launcher.hpp"

namespace sigmasweep {

void complain(const std::string& message, Speaker speaker) {
  if (speaker == Speaker::each_process || launched_rank() == 0)
    print_on_stderr(fmt::format("sigmasweep: {}\n", message));
}

}  // namespace sigmasweep

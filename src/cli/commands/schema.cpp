#include "sweep/reference/schema.hpp"

#include <fmt/format.h>

#include "cli/command.hpp"
#include "studies/sections.hpp"

namespace sigmasweep {
namespace {

struct NoOptions {};

}  // namespace

Command schema_command() {
  return make_command<NoOptions>(
      "schema", "Print the JSON schema of specs, for editors",
      "\nAn editor with a language server for TOML, such as taplo, completes and checks a spec whose first line is\n\n"
      "  #:schema sigmasweep.schema.json\n\n"
      "  sigmasweep schema > sigmasweep.schema.json",
      [](OptionSet&, NoOptions&) {},
      [](const NoOptions&) {
        fmt::print("{}\n", spec_schema(study_sections));
        return 0;
      });
}

}  // namespace sigmasweep

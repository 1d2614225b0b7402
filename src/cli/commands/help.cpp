#include <fmt/format.h>

#include "cli/command.hpp"
#include "studies/sections.hpp"
#include "sweep/reference/reference.hpp"

namespace sigmasweep {
namespace {

struct HelpOptions {
  std::string topic;
};

int print_help(const HelpOptions& options) {
  const std::string text = options.topic == "plot"     ? plot_reference()
                           : options.topic == "fields" ? field_reference()
                                                       : spec_reference(study_sections);
  fmt::print("{}", text);
  return 0;
}

void declare(OptionSet& set, HelpOptions& options) {
  set.add({"topic",
           "spec: all that a spec may have; plot: its [plot]; fields: parameters and results",
           "spec|plot|fields",
           {"spec", "plot", "fields"}},
          options.topic);
}

}  // namespace

Command help_command() {
  return make_command("help", "Explain specs, plots, or the fields of rows", "\n  sigmasweep help spec | less", declare,
                      print_help);
}

}  // namespace sigmasweep

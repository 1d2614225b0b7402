#include "cli/command.hpp"
#include "cli/settings_option.hpp"
#include "studies/sections.hpp"
#include "studies/stability/command.hpp"

namespace sigmasweep {
namespace {

void declare(OptionSet& set, StabilityOptions& options) {
  options.run.sections = study_sections;
  set.add({"spec", "A sweep spec with integrators of fixed step and steps_per_tc", "SPEC.toml"}, options.run.spec);
  add_settings(set, options.run.settings);
  set.add({"-o,--output", "The table; default: the spec's name with .h5, in this directory", "TABLE.h5"},
          options.run.output);
  set.add_flag("--fresh", "Start again and replace an existing table or journal", options.run.fresh);
  set.add_flag("--no-plots", "No pictures", options.plots, false);
  set.add_flag("-q,--quiet", "Neither progress nor summary", options.run.quiet);
}

}  // namespace

Command stability_command() {
  return make_command(
      "stability", "Find the time steps at which integrators of fixed step are stable",
      "\nRuns the sweep, or goes on with it, as 'run' does. Prints computed and predicted stability, and draws both\n"
      "to TABLE.svg and TABLE.png. Unstable rows do not count as failures.\n\n"
      "  mpirun -n 2 sigmasweep stability stability.toml",
      declare, stability_study);
}

}  // namespace sigmasweep

#include "cli/command.hpp"
#include "cli/settings_option.hpp"
#include "studies/precision/command.hpp"

namespace sigmasweep {
namespace {

void declare(OptionSet& set, PrecisionOptions& options) {
  set.add({"spec", "A sweep spec with a section [precision]", "SPEC.toml"}, options.spec);
  add_settings(set, options.settings);
  set.add({"-o,--output", "The table; default: the spec's name with .h5, in this directory", "TABLE.h5"},
          options.output);
  set.add({"--tuples", "Number of contact phases per scene, instead of the spec's", "COUNT"}, options.tuples,
          {1, 1'000'000});
  set.add({"--repeats", "Number of timings, the smallest of which counts, instead of the spec's", "COUNT"},
          options.repeats, {1, 1000});
  set.add_flag("--no-plots", "No pictures", options.plots, false);
  set.add_flag("-q,--quiet", "No progress", options.quiet);
}

}  // namespace

Command precision_command() {
  return make_command(
      "precision", "Measure error against run time of every integrator",
      "\nPrints a table and writes it to TABLE.h5, and its plots to TABLE.svg and TABLE.png. Under mpirun one rank\n"
      "measures each scene; let mpirun bind ranks to cores (--bind-to core).\n\n"
      "  mpirun -n 2 --bind-to core sigmasweep precision precision.toml\n"
      "  sigmasweep precision precision.toml --tuples 10 --repeats 1",
      declare, precision_study);
}

}  // namespace sigmasweep

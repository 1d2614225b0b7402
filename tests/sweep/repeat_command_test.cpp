#include "sweep/repeat_command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {
namespace {

/// The tuple of a command, as 'one' reads it.
Parameters typed(const std::string& command) {
  std::istringstream words(command);
  std::string word, value, spec = "[sweep]\n";
  words >> word >> word;  // sigmasweep one
  while (words >> word >> value) {
    std::string name = word.substr(2);
    std::ranges::replace(name, '-', '_');
    const bool is_name = !enumerators(find_field(name)->type).empty() && value != "true" && value != "false";
    spec += name + " = " + (is_name ? "\"" + value + "\"" : value) + "\n";
  }
  return Sweep::parse(spec, "typed").at(0);
}

TEST(RepeatCommand, GivesTheTupleToTheBit) {
  const std::string column = "v0 = 0.3\nN = [1, 7]\n", contact = "tc = 1.1e-5\nepsilon = 0.7\n";
  const std::vector<std::string> specs{
      column + contact + "sigma = [0, 1e-3, 0.3, 7]\nmethod = [\"md\", \"ed\"]\n",
      column + contact + "s0 = [0, 1e-7, 3.3e-5]\nwall = \"matched\"\n",
      column + contact + "s0 = 1e-6\nwidth = 1e-4\nseed = [1, 9007199254740993]\nrandom_separation = true\n",
      column + "K_over_m = 1e10\nD_n = [0, 1e3, 2e5]\nsigma = 0.1\n",
      column + "K_over_m = 1e14\nD_n = 1e5\nsigma = 0.1\nlaw = [\"hertz\", \"hertz-kuwabara-kono\"]\n",
      column + "material = \"steel\"\nlaw = \"hertz\"\ns0 = 1e-6\n",
      column + contact + "sigma = 0.1\nlaw = \"power\"\nbeta = 0.3\ngamma = 0.1\n",
      column + contact + "sigma = 0.1\nintegrator = [\"verlet\", \"gear5\"]\nsteps_per_tc = [33, 100]\n",
      column + contact + "sigma = 0.1\nintegrator = \"verlet\"\ntolerance = [1e-3, 1e-10]\n",
      column + contact + "sigma = 0.1\ntolerance = 1e-5\n",
      column + contact + "sigma = 0.1\nmethod = \"ed\"\ned_rule = \"tc\"\n",
      "v0 = 1\n" + contact +
          "geometry = \"lattice\"\nrows = 3\ncolumns = [4, 13]\ns0 = 1e-6\nD_t = 100\nside_walls = "
          "\"fixed\"\n",
      contact + "geometry = \"vibrated-column\"\nN = 4\nfrequency = [20, 33]\nalpha = [1.7, 4]\nperiods = 33\n",
      contact + "geometry = \"vibrated-column\"\nN = 4\nfrequency = 20\nA0 = [1e-3, 3.3e-4]\n",
      contact + "geometry = \"vibrated-lattice\"\nrows = 2\nfrequency = 20\nalpha = 2\n"};
  for (const std::string& keys : specs) {
    const Sweep sweep = Sweep::parse("[sweep]\n" + keys, "spec");
    for (std::uint64_t row = 0; row < sweep.size(); ++row) {
      const std::string command = repeat_command(sweep.at(row));
      EXPECT_EQ(content_key(typed(command)), content_key(sweep.at(row))) << command;
    }
  }
}

}  // namespace
}  // namespace sigmasweep

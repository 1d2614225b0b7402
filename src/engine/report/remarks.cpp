#include "engine/report/remarks.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/report/duplicate_rows.hpp"
#include "engine/report/unstable_rows.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t most_examined = 1'000'000;

bool gives(const Sweep& sweep, std::string_view parameter) {
  return std::ranges::find(sweep.columns(), parameter, &Field::name) != sweep.columns().end();
}

/// The law of hard spheres counts where epsilon follows from stiffness and damping.
bool has_hard_spheres_of_nonlinear_law(const Sweep& sweep) {
  if (!gives(sweep, "law") || !(gives(sweep, "K_over_m") || gives(sweep, "material"))) return false;
  const std::uint64_t examined = std::min(sweep.size(), most_examined), stride = sweep.size() / examined;
  for (std::uint64_t k = 0; k < examined; ++k) {
    const Parameters p = sweep.at(k * stride);
    if (p.method == Method::ed && !exponents(p).linear()) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> remarks_on(const Sweep& sweep) {
  std::vector<std::string> remarks;
  if (gives(sweep, "K_over_m") && !gives(sweep, "D_n"))
    remarks.emplace_back("K_over_m is given without D_n: the beads are elastic, epsilon = 1 (D_n = 0 says so, too)");
  if (has_hard_spheres_of_nonlinear_law(sweep))
    remarks.emplace_back(
        "method = 'ed' with a law that is not linear: epsilon is that of the law at v0, and all collisions have it, "
        "whatever their speed");
  for (std::string& warning : std::array{stability_warning(sweep), duplicate_warning(sweep)})
    if (!warning.empty()) remarks.push_back(std::move(warning));
  return remarks;
}

}  // namespace sigmasweep

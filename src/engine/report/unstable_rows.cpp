#include "engine/report/unstable_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "solve/fixed_step/stability.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t max_rows = 1'000'000;
/// Signatures beyond these numbers, a second or two of computing each, count as stable. Dashpots of laws that are not
/// linear take up to 0.1 s each, and so do the modes of a lattice of unequal beads.
constexpr std::size_t max_signatures = 20'000, max_slow = 30;

/// The closed contacts of tuples by their signature.
class KnownContacts {
 public:
  /// The closed contacts of the tuple; nullptr where there is no time to find them.
  const ClosedContacts* find(const Parameters& p) {
    const StabilitySignature signature = stability_signature(p);
    if (const auto known = known_.find(signature); known != known_.end()) return &known->second;
    if (known_.size() >= max_signatures || !has_time_for(p)) return nullptr;
    return &known_.try_emplace(signature, closed_contacts(p)).first->second;
  }

 private:
  bool has_time_for(const Parameters& p) {
    if (has_searched_motions(p) && ++slow_lattices_ > max_slow) return false;
    const auto [beta, gamma] = exponents(p);
    if (exponents(p).linear() || p.K_over_m > 0.0) return true;
    if (slow_dashpots_.size() < max_slow) slow_dashpots_.insert({beta, gamma, p.epsilon});
    return slow_dashpots_.contains({beta, gamma, p.epsilon});
  }

  std::map<StabilitySignature, ClosedContacts> known_;
  std::set<std::array<double, 3>> slow_dashpots_;
  std::size_t slow_lattices_ = 0;
};

struct Unstable {
  std::uint64_t rows = 0;
  double lowest = 1.0, highest = 0.0;  ///< epsilon
};

}  // namespace

std::string stability_warning(const Sweep& sweep) {
  const bool one_integrator = std::ranges::find(sweep.axes(), "integrator") == sweep.axes().end();
  if (one_integrator && sweep.at(0).integrator == Integrator::exact) return {};
  KnownContacts contacts;
  std::map<std::tuple<const ClosedContacts*, Integrator, double>, bool> stable;
  std::map<std::pair<Integrator, double>, Unstable> unstable;
  const std::uint64_t looked_at = std::min(sweep.size(), max_rows), stride = sweep.size() / looked_at;
  std::uint64_t all = 0;
  for (std::uint64_t k = 0; k < looked_at; ++k) {
    const Parameters p = sweep.at(k * stride);
    if (!has_given_steps(p)) continue;
    const ClosedContacts* closed = contacts.find(p);
    if (!closed) continue;
    const auto [found, is_new] = stable.try_emplace({closed, p.integrator, p.steps_per_tc});
    if (is_new) found->second = is_stable(*closed, p.integrator, 1.0 / p.steps_per_tc);
    if (found->second) continue;
    Unstable& group = unstable[{p.integrator, p.steps_per_tc}];
    group.lowest = group.rows ? std::min(group.lowest, p.epsilon) : p.epsilon;
    group.highest = std::max(group.highest, p.epsilon);
    ++group.rows;
    ++all;
  }
  if (all == 0) return {};
  const auto& [scheme, most] = *std::ranges::max_element(unstable, {}, [](const auto& g) { return g.second.rows; });
  const std::string others = unstable.size() > 1 ? fmt::format(", mostly {}", most.rows) : "";
  const std::string range = most.lowest == most.highest
                                ? fmt::format("epsilon = {:.4g}", most.highest)
                                : fmt::format("epsilon from {:.4g} to {:.4g}", most.lowest, most.highest);
  return fmt::format("{}{} of {} tuples are predicted to be unstable{}: {} at tc/{:.4g} with {}",
                     stride > 1 ? "in a sample, " : "", all, looked_at, others, name_of(scheme.first), scheme.second,
                     range);
}

}  // namespace sigmasweep

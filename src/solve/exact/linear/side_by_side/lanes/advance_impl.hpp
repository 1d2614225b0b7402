#pragma once

#include "solve/exact/linear/side_by_side/lanes/first_event.hpp"
#include "solve/exact/linear/side_by_side/lanes/motion.hpp"

namespace sigmasweep::side_by_side {

/// Sorts the contacts into runs and such as fly uniformly in all lanes.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void find_runs(Columns<W, HasUnequalMasses>& c) {
  const Mask<W> active = Mask<W>::load(c.active);
  c.run_count = 0;
  bool in_run = false;
  for (int k = 0; k < c.N; ++k) {
    const bool live = any(active & ~flies_on<W>(c, k));
    if (live && !in_run) c.runs[c.run_count++].first = k;
    if (live) c.runs[c.run_count - 1].last = k;
    in_run = live;
  }
}

/// The derivatives of contacts and disturbances that do more than fly.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void expand_runs(Columns<W, HasUnequalMasses>& c) {
  const auto accelerated = [&](int k, Pack<W> force) SIGMASWEEP_INLINE_LAMBDA {
    return HasUnequalMasses ? Pack<W>::load(c.inverse_mass[k]) * force : force;
  };
  const auto disturbed = [&](int k, Pairs<W> force) SIGMASWEEP_INLINE_LAMBDA {
    return HasUnequalMasses ? in_pairs(Pack<W>::load(c.inverse_mass[k])) * force : force;
  };
  for (int r = 0; r < c.run_count; ++r) {
    const auto [first, last] = c.runs[r];
    expand<order, Pack<W>>(c.a, c.acting_spring, c.acting_dashpot, accelerated, first, last);
    expand<disturbed_order, Pairs<W>>(c.d, c.disturbed_spring, c.disturbed_dashpot, disturbed, first, last);
  }
}

/// Every active column flies to its next contact if nothing touches, and goes on by a step, to the first event in it.
template <int W, bool HasUnequalMasses>
SIGMASWEEP_LANEWISE void advance_columns(Columns<W, HasUnequalMasses>& c) {
  long long free[W];
  for (int l = 0; l < W; ++l) free[l] = c.closed_bits[l] == 0 ? c.active[l] : 0;
  if (const auto flies = Mask<W>::load(free); any(flies)) fly<W>(c, flies);
  find_runs<W>(c);
  expand_runs<W>(c);
  find_first_event<W>(c, Mask<W>::load(c.active));
  move<W>(c);
  for (int l = 0; l < W; ++l)
    if (c.active[l] && c.event[l] >= 0) change_contact(c, c.event[l], l);
}

}  // namespace sigmasweep::side_by_side

#pragma once

#include "solve/exact/linear/side_by_side/lanes/first_event.hpp"
#include "solve/exact/linear/side_by_side/lanes/motion.hpp"

namespace sigmasweep::side_by_side {

/// Sorts the contacts into runs and such as fly uniformly in all lanes.
template <int W>
SIGMASWEEP_LANEWISE void find_runs(Columns<W>& c) {
  const Mask<W> active = Mask<W>::load(c.active);
  c.run_count = 0;
  bool in_run = false;
  for (int k = 0; k < c.N; ++k) {
    const bool live = any(active & ~flies_on<W>(c, k));
    Mask<W>::none().store(c.suspect[k]);
    if (live && !in_run) c.runs[c.run_count++].first = k;
    if (live) c.runs[c.run_count - 1].last = k;
    in_run = live;
  }
}

/// Every active column flies to its next contact if nothing touches, and goes on by a step, to the first event in it.
template <int W>
SIGMASWEEP_LANEWISE void advance_columns(Columns<W>& c) {
  const int N = c.N;
  put_right<W>(c);
  Mask<W> touching = Mask<W>::none();
  for (int k = 0; k < N; ++k) touching = touching | Mask<W>::load(c.closed[k]);
  if (const Mask<W> free = Mask<W>::load(c.active) & ~touching; any(free)) {
    fly<W>(c, free);
    put_right<W>(c);
  }
  find_runs<W>(c);
  for (int r = 0; r < c.run_count; ++r) {
    for (int k = c.runs[r].first; k <= c.runs[r].last; ++k) {
      __builtin_memcpy(c.a[k], c.x[k], sizeof c.x[k]);
      __builtin_memcpy(c.a[N + k], c.u[k], sizeof c.u[k]);
      __builtin_memcpy(c.d[k], c.dx[k], sizeof c.dx[k]);
      __builtin_memcpy(c.d[N + k], c.du[k], sizeof c.du[k]);
    }
    expand<W, order>(c, c.a, c.runs[r].first, c.runs[r].last);
    expand<W, disturbed_order>(c, c.d, c.runs[r].first, c.runs[r].last);
  }
  find_first_event<W>(c, Mask<W>::load(c.active));
  move<W>(c);
  for (int l = 0; l < W; ++l)
    if (c.active[l] && c.event[l] >= 0) change_contact(c, c.event[l], l);
}

}  // namespace sigmasweep::side_by_side

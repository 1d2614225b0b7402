#pragma once

namespace sigmasweep::side_by_side {

struct FirstEvent {
  double when;  ///< within [0, 1]
  int contact;  ///< -1: none
};

/// The first event of one lane, by isolating the roots of each suspect contact. Derivative p of contact k is
/// a[(p most_beads + k) stride]; flags are those of contact k at k stride.
FirstEvent first_event_of_lane(const double* a, const long long* closed, const long long* suspect, int stride, int N);

}  // namespace sigmasweep::side_by_side

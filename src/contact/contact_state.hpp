#pragma once

namespace sigmasweep {

/// Overlap x of a contact (x < 0: a gap of -x) and its rate u = x'.
template <class Real>
struct ContactState {
  Real x{}, u{};
};

}  // namespace sigmasweep

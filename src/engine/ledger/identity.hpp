#pragma once

#include <span>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/journal/record.hpp"
#include "sweep/slice.hpp"

namespace sigmasweep {

/// The results that are columns of the sweep's table. The journals have these.
std::vector<Field> journalled_results(const Sweep& sweep);

/// The identity of the sweep's journals, with those results, which must outlive it; a slice of the sweep has another
/// identity than the sweep.
JournalIdentity journal_identity(const Sweep& sweep, const Slice& slice, std::span<const Field> results);

}  // namespace sigmasweep

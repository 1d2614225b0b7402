#pragma once

#include <optional>

namespace sigmasweep {

/// Whether the manager rank also computes. Automatic means that it does unless there are many ranks.
enum class ManagerRole { automatic, computes, dedicated };

/// The table [run] of a spec, options of the computation. No result depends on it.
///
///     manager          = "auto"   # or "computes", "dedicated"
///     tuple_time_limit = 60       # CPU time after which a tuple is given up, s
struct RunSpec {
  ManagerRole manager = ManagerRole::automatic;
  std::optional<double> tuple_time_limit{};
};

}  // namespace sigmasweep

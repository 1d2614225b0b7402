#pragma once

#include <optional>

namespace sigmasweep {

/// Whether the manager rank also computes. automatic: yes, unless there are many ranks.
enum class ManagerRole { automatic, computes, dedicated };

/// [run] of a spec: how it is computed. Not part of what a tuple is.
///
///     manager          = "auto"   # or "computes", "dedicated"
///     tuple_time_limit = 60       # CPU time after which a tuple is given up, s
struct RunSpec {
  ManagerRole manager = ManagerRole::automatic;
  std::optional<double> tuple_time_limit{};
};

}  // namespace sigmasweep

#include "sweep/spec/run.hpp"

#include <array>

#include "sweep/spec/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::array<std::string_view, 2> keys{"manager", "tuple_time_limit"};
constexpr std::array<std::string_view, 3> managers{"auto", "computes", "dedicated"};

}  // namespace

RunSpec read_run(const Entry& run) {
  RunSpec spec;
  Mistakes mistakes;
  const auto read = [&](const Entry& entry) {
    if (entry.name == "manager") {
      spec.manager = static_cast<ManagerRole>(as_one_of(entry, managers));
    } else if (entry.name == "tuple_time_limit") {
      spec.tuple_time_limit = as_number(entry);
      if (!(*spec.tuple_time_limit > 0.0)) refuse_value(entry, "must be a time > 0, in s");
    } else {
      refuse_unknown(entry, keys);
    }
  };
  for (const Entry& entry : entries(as_table(run), *run.file, run.path)) mistakes.keep([&] { read(entry); });
  mistakes.refuse_any();
  return spec;
}

}  // namespace sigmasweep::spec

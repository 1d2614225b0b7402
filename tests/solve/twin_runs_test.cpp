#include "solve/twin_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <type_traits>
#include <vector>

/// The accuracies of runs that meet a tolerance, for errors that grow from the local accuracy in known ways.
namespace sigmasweep {
namespace {

struct Call {
  bool wide;
  double accuracy;
};
struct Calls {
  SimulationResult result;
  std::vector<Call> all;
  bool any_wide() const { return std::ranges::any_of(all, &Call::wide); }
};

/// Refines where the error bar of a run is error(wide, accuracy).
Calls refine(double tolerance, const std::function<double(bool, double)>& error) {
  Calls calls;
  calls.result = refine_until(tolerance, 1e-8, [&]<class Real>(double accuracy) {
    const bool wide = !std::is_same_v<Real, double>;
    calls.all.push_back({wide, accuracy});
    SimulationResult c;
    c.status = Status::ok;
    c.eps_eff_error = error(wide, accuracy);
    return c;
  });
  return calls;
}

/// Doubles of that growth keep errors of 1e-16 times it.
std::function<double(bool, double)> grows_by(double growth) {
  return [=](bool wide, double accuracy) { return growth * std::max(accuracy, wide ? 0.0 : 1e-16); };
}

TEST(RefineUntil, IsDoneAtOnceWhereErrorsAreSmall) {
  for (const double tolerance : {1e-2, 1e-6, 1e-12}) {
    const Calls calls = refine(tolerance, grows_by(100.0));
    EXPECT_EQ(calls.result.status, Status::ok);
    ASSERT_EQ(calls.all.size(), 1U);
    EXPECT_LE(calls.all[0].accuracy, 1e-8);
  }
}

/// Where the growth is steady the second run meets the tolerance, in doubles if these can.
TEST(RefineUntil, KnowsFromOneRunWhatTheNextOneNeeds) {
  const Calls calls = refine(1e-6, grows_by(1e6));
  EXPECT_EQ(calls.result.status, Status::ok);
  EXPECT_EQ(calls.all.size(), 2U);
  EXPECT_FALSE(calls.any_wide());
}

/// Runs whose events come in another order differ by much more than errors grow: they do not say how fine the next ones
/// must be, nor that doubles are not enough.
TEST(RefineUntil, TakesNoWideTypeBecauseCoarseRunsTellNothing) {
  for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    const auto error = [](bool, double accuracy) { return accuracy > 3e-11 ? 1.0 : 1e3 * accuracy; };
    const Calls calls = refine(tolerance, error);
    EXPECT_EQ(calls.result.status, Status::ok) << tolerance;
    EXPECT_FALSE(calls.any_wide()) << tolerance;
    EXPECT_LE(calls.all.size(), 3U) << tolerance;
  }
}

/// The finest doubles are tried first, and their rounding does not hide how errors grow.
TEST(RefineUntil, TakesAWideTypeWhereDoublesRound) {
  const auto error = [](bool wide, double accuracy) { return 1e6 * (accuracy + (wide ? 0.0 : 1e-14)); };
  const Calls calls = refine(1e-10, error);
  EXPECT_EQ(calls.result.status, Status::ok);
  EXPECT_TRUE(calls.all.back().wide);
  EXPECT_EQ(std::ranges::count_if(calls.all, &Call::wide), 1);
}

TEST(RefineUntil, EveryRunIsFinerAndTheSmallestErrorStays) {
  const auto chaos = [](bool, double accuracy) { return accuracy > 2e-12 ? 0.3 : 0.4; };
  const Calls calls = refine(1e-4, chaos);
  EXPECT_EQ(calls.result.status, Status::tolerance_missed);
  EXPECT_EQ(calls.result.eps_eff_error, 0.3);
  for (std::size_t i = 1; i < calls.all.size(); ++i)
    EXPECT_LE(calls.all[i].accuracy, 0.1001 * calls.all[i - 1].accuracy);
  EXPECT_LE(calls.all.size(), 8U);
}

/// An error that not even the finest long double would do for is not waited for.
TEST(RefineUntil, GivesUpWhatIsHopeless) {
  const Calls calls = refine(1e-10, grows_by(1e13));
  EXPECT_EQ(calls.result.status, Status::tolerance_missed);
  EXPECT_FALSE(calls.any_wide());
}

}  // namespace
}  // namespace sigmasweep

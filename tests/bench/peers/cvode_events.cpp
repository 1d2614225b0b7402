#include "bench/peers/cvode_events.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>

#include "bench/peers/located_events.hpp"

namespace sigmasweep::peers {
namespace {

/// CVODE's Adams formulas with functional iteration, as no contact is stiff. It is started again after each event, at
/// its own time 0, because it locates roots to 100 roundings of the time.
class Adams {
 public:
  explicit Adams(double tolerance) : tolerance_(tolerance) {
    SUNContext_Create(nullptr, &context_);
    vector_ = N_VMake_Serial(2 * beads, y_.data(), context_);
    memory_ = CVodeCreate(CV_ADAMS, context_);
    iteration_ = SUNNonlinSol_FixedPoint(vector_, 0, context_);
    CVodeInit(memory_, right_hand_side, 0.0, vector_);
    CVodeSStolerances(memory_, tolerance, tolerance);
    CVodeSetNonlinearSolver(memory_, iteration_);
    CVodeSetUserData(memory_, this);
    CVodeSetMaxNumSteps(memory_, 100'000);
    CVodeSetErrFile(memory_, nullptr);
    CVodeRootInit(memory_, beads, overlaps);
    CVodeSetNoInactiveRootWarn(memory_);
  }
  Adams(const Adams&) = delete;
  Adams& operator=(const Adams&) = delete;
  ~Adams() {
    CVodeFree(&memory_);
    SUNNonlinSolFree(iteration_);
    N_VDestroy(vector_);
    SUNContext_Free(&context_);
  }

  std::size_t next_event(BetweenTwoEvents& now, const Closed& closed) {
    constexpr double much_later = 1e3;
    equations_.closed = closed;
    std::ranges::copy(now.y, y_.begin());
    start_ = now.y;
    CVodeReInit(memory_, 0.0, vector_);
    set_directions(closed);
    double t = 0.0;
    if (CVode(memory_, much_later, vector_, &t, CV_NORMAL) != CV_ROOT_RETURN) return beads;
    std::ranges::copy(y_, now.y.begin());
    now.t += t;
    std::array<int, beads> found{};
    CVodeGetRootInfo(memory_, found.data());
    return static_cast<std::size_t>(std::ranges::find_if(found, [](int root) { return root != 0; }) - found.begin());
  }

 private:
  static int right_hand_side(double, N_Vector y, N_Vector rate, void* self) {
    const BetweenEvents& equations = static_cast<Adams*>(self)->equations_;
    Closed force;
    const double* now = N_VGetArrayPointer(y);
    for (std::size_t k = 0; k < beads; ++k)
      force[k] = equations.closed[k] * (equations.law.K * now[k] + equations.law.C * now[beads + k]);
    accelerate(force, std::span<const double, 2 * beads>(now, 2 * beads),
               std::span<double, 2 * beads>(N_VGetArrayPointer(rate), 2 * beads));
    return 0;
  }

  /// CVODE takes no notice of a function that is 0 at the start. A contact that has just opened or closed, x_k(0) = 0,
  /// has its next event at the root of x_k(t)/t, which begins at x_k'(0). One that begins at rest, x_k = x_k' = 0, is
  /// pressed so slowly at first that the errors of the steps would open it: it opens below 0 by the tolerance.
  static int overlaps(double t, N_Vector y, double* value, void* self) {
    const Adams& adams = *static_cast<Adams*>(self);
    const double* x = N_VGetArrayPointer(y);
    for (std::size_t k = 0; k < beads; ++k) {
      const double x0 = adams.start_[k], u0 = adams.start_[beads + k];
      if (x0 != 0.0)
        value[k] = x[k];
      else if (u0 == 0.0)
        value[k] = x[k] + adams.tolerance_;
      else
        value[k] = t > 0.0 ? x[k] / t : u0;
    }
    return 0;
  }

  void set_directions(const Closed& closed) {
    std::array<int, beads> directions;
    for (std::size_t k = 0; k < beads; ++k) directions[k] = closed[k] > 0.0 ? -1 : 1;
    CVodeSetRootDirection(memory_, directions.data());
  }

  double tolerance_;
  State y_{}, start_{};
  BetweenEvents equations_;
  SUNContext context_ = nullptr;
  N_Vector vector_ = nullptr;
  void* memory_ = nullptr;
  SUNNonlinearSolver iteration_ = nullptr;
};

}  // namespace

std::vector<Method> cvode_methods() {
  std::vector<Method> methods;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    methods.push_back(one_by_one("CVODE Adams, events", fmt::format("{:.0e}", tolerance), [tolerance](const Tuple& t) {
      Adams solver(tolerance);
      return collision_with_events(solver, t.sigma(), 1e-3 * tolerance).eps_eff;
    }));
  return methods;
}

}  // namespace sigmasweep::peers

#include "assembly/ground.hpp"

#include <boost/math/tools/roots.hpp>
#include <cstdint>

namespace sigmasweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double turn = 2.0 * std::numbers::pi;
constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr int bisections = 200;

struct Sine {
  double whole, less_angle;  ///< sin(angle), sin(angle) - angle
};

Sine sine_of(double angle) {
  if (std::fabs(angle) > 1.0) return {std::sin(angle), std::sin(angle) - angle};
  double sum = 0.0, term = -angle * angle * angle / 6.0;
  for (double n = 4.0; sum + term < sum || sum + term > sum; n += 2.0) {
    sum += term;
    term *= -angle * angle / (n * (n + 1.0));
  }
  return {angle + sum, sum};
}

/// Time until x is 0 under a constant load; NaN or infinite if it never is. All numbers may have either sign.
double fall_time(const ContactState<double>& start, double load) {
  const double root = std::sqrt(start.u * start.u - 2.0 * load * start.x);
  return start.u > 0.0 ? -2.0 * start.x / (start.u + root) : (root - start.u) / load;
}

/// The plate's phase at t, s, without whole periods, so that it is as exact after many of them.
double phase(const Parameters& p, double t) {
  const double turns = p.frequency * t;
  return 2.0 * std::numbers::pi * (turns - std::floor(turns));
}

}  // namespace

ContactState<double> Plate::flight(const ContactState<double>& entry, double t, double elapsed) const {
  const double phase = omega * t, angle = omega * elapsed, half = std::sin(0.5 * angle);
  const double less_one = -2.0 * half * half;  // cos(angle) - 1
  const double sine = std::sin(phase), cosine = std::cos(phase);
  const Sine turned = sine_of(angle);
  return {
      entry.x + entry.u * elapsed + 0.5 * g * elapsed * elapsed + A0 * (sine * less_one + cosine * turned.less_angle),
      entry.u + g * elapsed + A0 * omega * (cosine * less_one - sine * turned.whole)};
}

double Plate::landing(ContactState<double> entry, double t) const {
  entry.x = std::min(entry.x, 0.0);
  for (double from = certain_flight(entry, t);;) {
    const Piece piece = piece_from(t, from);
    const ContactState<double> start = from > 0.0 ? flight(entry, t, from) : entry;
    if (std::isnan(start.x)) return start.x;
    if (start.x >= 0.0 && (start.u > 0.0 || (start.u == 0.0 && !piece.concave))) return from;
    double to = piece.end;
    if (piece.concave) {
      if (start.u > 0.0) {
        if (flight(entry, t, to).u < 0.0) to = highest(entry, t, from, to);
        if (flight(entry, t, to).x >= 0.0) return root(entry, t, from, to, from);
      }
    } else {
      double guess = fall_time(start, load(t + from)), x;
      if (!(guess > 0.0 && guess < 0.25 * period())) guess = 0.25 * period();
      double width = 1.01 * guess;
      do {
        to = std::min(piece.end, from + width);
        x = flight(entry, t, to).x;
        width *= 2.0;
      } while (x < 0.0 && to < piece.end);
      if (x >= 0.0) return root(entry, t, from, to, std::min(from + guess, to));
    }
    from = piece.end;
  }
}

double Plate::take_off(double t) const {
  const Piece piece = piece_from(t, 0.0);
  return piece.concave ? t : t + piece.end;
}

/// A time at which a bead that was thrown high is still above the highest point of the plate. With it landing() does
/// not search the periods before.
double Plate::certain_flight(const ContactState<double>& now, double t) const {
  const double above = height(t) - now.x - A0, up = speed(t) - now.u;
  if (!(above > 0.0)) return 0.0;
  return std::max(0.0, (up + std::sqrt(up * up + 2.0 * g * above)) / g - 0.01 * period());
}

/// The time from `from` on during which the load keeps its sign.
auto Plate::piece_from(double t, double from) const -> Piece {
  if (!(alpha() > 1.0)) return {infinity, false};
  const double rise = std::asin(1.0 / alpha());  // the load is below 0 at phases between this and pi - this
  const double now = omega * (t + from), little = 4.0 * rounding * (1.0 + std::fabs(now));
  const double begun = turn * std::floor((now + little) / turn), phase = now + little - begun;
  const double until = phase < rise ? rise : phase < std::numbers::pi - rise ? std::numbers::pi - rise : turn + rise;
  return {from + (begun + until - now) / omega, until == std::numbers::pi - rise};
}

/// The time between low and high at which the closing speed, which falls from positive to negative, is 0.
double Plate::highest(const ContactState<double>& entry, double t, double low, double high) const {
  const auto closing_speed = [&](double elapsed) { return flight(entry, t, elapsed).u; };
  const boost::math::tools::eps_tolerance<double> last_bit(std::numeric_limits<double>::digits);
  std::uintmax_t most = bisections;
  return boost::math::tools::toms748_solve(closing_speed, low, high, last_bit, most).first;
}

/// The only time between low and high at which the overlap rises through 0. At low it is below 0, or 0 and falling; at
/// high it is not below 0.
double Plate::root(const ContactState<double>& entry, double t, double low, double high, double guess) const {
  for (int i = 0; i < bisections; ++i) {
    const ContactState<double> here = flight(entry, t, guess);
    (here.x < 0.0 ? low : high) = guess;
    double next = guess - here.x / here.u;
    if (!(here.u > 0.0 && next >= low && next <= high)) {
      next = 0.5 * (low + high);
    } else if (const double step = next - guess; step * step * (g + A0 * omega * omega) <= rounding * here.u * guess) {
      return next;  // what the curve can still bend away within a step is rounding
    }
    if (next == guess) break;
    guess = next;
  }
  return guess;
}

double plate_height(const Parameters& p, double t) { return p.A0 * std::sin(phase(p, t)); }

double plate_speed(const Parameters& p, double t) {
  return p.A0 * 2.0 * std::numbers::pi * p.frequency * std::cos(phase(p, t));
}

}  // namespace sigmasweep

#pragma once

namespace sigmasweep {

/// A vector in the plane of a lattice: x to the right, z upwards.
template <class Real>
struct Vec2 {
  Real x{}, z{};

  Vec2& operator+=(const Vec2& b) { return *this = *this + b; }
  Vec2& operator-=(const Vec2& b) { return *this = *this - b; }
  friend Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.z + b.z}; }
  friend Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.z - b.z}; }
  friend Vec2 operator-(const Vec2& a) { return {-a.x, -a.z}; }
  friend Vec2 operator*(const Real& s, const Vec2& a) { return {s * a.x, s * a.z}; }
  friend Real dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.z * b.z; }
  /// The vector turned by 90 degrees: t_ij of n_ij in Eq. (4).
  friend Vec2 turned(const Vec2& a) { return {-a.z, a.x}; }
};

}  // namespace sigmasweep

// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Caps about points where D is curved. At n, of length 1, let a curved piece of a body have the point y about
// its centre, h = n·y and S = L Lᵀ with the support function |Lᵀu|. For u = n + t, t across n,
//
//     |Lᵀu|² = (h + y·t)² + tᵀM t,   M = S - y yᵀ,
//
// and |Lᵀu| >= h + y·t + q/(2 A + √q) with q = tᵀM t and A at least h + y·t. For |t| <= T the last term is at
// least |t|² φ(tᵀM t/|t|²), φ(m) = m/(2 A + T √m), A = h + T |y across n|. φ is concave, so that it is above
// its chord between the least and the largest m. With s the point of D and w what it has across n, this adds
// up to
//
//     h_D(u) >= n·s + w·t + tᵀK t >= L |u|   for   L <= n·s - |w|²/(4 κ - 2 n·s),   κ the least tᵀK t/|t|²,
//
// as |u| <= 1 + |t|²/2. Of two such points a and b whose shares are 1 - λ and λ the mean of both bounds is
// one, and the larger of both exceeds it by m = min(λ, 1 - λ) times their difference: at least m |d·t| less
// what the heights and K differ by, d = w_b - w_a, and |d·t| >= (d·t)²/(|d| T). As it is never below the
// mean, any part of that excess is a bound, too.
#include <algorithm>
#include <cmath>
#include <span>

#include "engine/methods/bodies/proven_cap.h"

namespace raygauge {
namespace {

// A symmetric form on the plane across n.
struct Form {
  double ee = 0, ef = 0, ff = 0;

  Form operator+(const Form& other) const { return {ee + other.ee, ef + other.ef, ff + other.ff}; }
  Form operator*(double s) const { return {ee * s, ef * s, ff * s}; }
  double half_spread() const { return std::sqrt(0.25 * (ee - ff) * (ee - ff) + ef * ef); }
  double least() const { return 0.5 * (ee + ff) - half_spread(); }
  double largest() const { return 0.5 * (ee + ff) + half_spread(); }
};

// Of what is across n rounding loses less than that share of the bodies' size. Where h is above kLeastHeight
// of the size, the direction of y is known to 1e-10, and M to that share of the square of the size.
constexpr double kRounding = 1e-13, kLeastHeight = 1e-6, kRoundingOfForm = 1e-10;

// 0 is a bound always.
Form chord(const PointBend::Piece& piece, double T, double size) {
  if (!(piece.height > kLeastHeight * size)) return {};
  const Form M{piece.ee, piece.ef, piece.ff};
  const double lost = kRoundingOfForm * size * size;
  const double least = std::max(M.least() - lost, 0.0), largest = std::max(M.largest() + lost, 0.0);
  const double twice = 2 * (piece.height + T * piece.across + kRounding * size);
  const double low = least / (twice + T * std::sqrt(least)),
               high = largest / (twice + T * std::sqrt(largest));
  const double slope = (high - low) / (largest - least), rest = low - slope * (least + lost);
  return Form{rest, 0, rest} + M * slope;
}

Form curvature(const PointBend& bend) {
  Form sum;
  for (const PointBend::Piece& piece : bend.of)
    if (piece.height > 0) sum = sum + Form{piece.ee, piece.ef, piece.ff} * (1 / piece.height);
  return sum;
}

}  // namespace

// The state of Newton's method for the least height near n.
struct ProvenCap::Bent {
  Vector3 e, f;
  int count = 1;
  double height[2] = {0, 0}, w[2][2] = {}, d[2] = {0, 0};
  PointBend bend[2];
  double share = 0, mean = 0, off[2] = {0, 0};

  double off_size() const { return std::sqrt(off[0] * off[0] + off[1] * off[1]); }
  double uneven() const { return count == 2 ? std::fabs(height[1] - height[0]) : 0.0; }
  bool is_settled(double precision) const;
  void look(const Vector3& n, const DepthPoint<double>* point, DepthOracle<double>& oracle);
  bool step(Vector3& n) const;
  double least_of(double T, double size, double part) const;
};

void ProvenCap::Bent::look(const Vector3& n, const DepthPoint<double>* point, DepthOracle<double>& oracle) {
  e = any_orthogonal(n);
  f = cross(n, e);
  for (int k = 0; k < count; ++k) {
    bend[k] = oracle.bend(n, e, f, point[k]);
    height[k] = dot(n, point[k].s);
    w[k][0] = dot(e, point[k].s);
    w[k][1] = dot(f, point[k].s);
  }
  share = 0;
  if (count == 2) {
    for (int k = 0; k < 2; ++k) d[k] = w[1][k] - w[0][k];
    const double square = d[0] * d[0] + d[1] * d[1];
    share = square > 0 ? std::clamp(-(w[0][0] * d[0] + w[0][1] * d[1]) / square, 0.0, 1.0) : 0.0;
  }
  const int other = count - 1;
  mean = height[0] + share * (height[other] - height[0]);
  for (int k = 0; k < 2; ++k) off[k] = w[0][k] + share * (w[other][k] - w[0][k]);
}

// To the least height: of one point that of the sphere's Hessian, K - n·s; of two where both are as high.
bool ProvenCap::Bent::step(Vector3& n) const {
  constexpr double kLongest = 0.5;
  const Form one = curvature(bend[0]), two = count == 2 ? curvature(bend[1]) : one;
  const Form H = one * (1 - share) + two * share + Form{-mean, 0, -mean};
  double x = 0, y = 0;
  if (count == 1) {
    const double determinant = H.ee * H.ff - H.ef * H.ef;
    if (!(determinant > 0 && H.ee > 0)) return false;
    x = -(H.ff * off[0] - H.ef * off[1]) / determinant;
    y = -(H.ee * off[1] - H.ef * off[0]) / determinant;
  } else {
    const double size = std::sqrt(d[0] * d[0] + d[1] * d[1]);
    if (!(size > 0)) return false;
    const double c = d[0] / size, s = d[1] / size, along = (height[0] - height[1]) / size;
    const double across = H.ee * s * s - 2 * H.ef * s * c + H.ff * c * c;
    const double mixed = (H.ff - H.ee) * s * c + H.ef * (c * c - s * s);
    if (!(across > 0)) return false;
    const double turn = -(off[1] * c - off[0] * s + along * mixed) / across;
    x = along * c - turn * s;
    y = along * s + turn * c;
  }
  if (!(x * x + y * y < kLongest * kLongest)) return false;
  n = n + e * x + f * y;
  n = n * (1 / std::sqrt(dot(n, n)));
  return true;
}

// κ for this T, with that part of what the larger of two bounds exceeds their mean by.
double ProvenCap::Bent::least_of(double T, double size, double part) const {
  Form K[2];
  for (int k = 0; k < count; ++k) K[k] = chord(bend[k].of[0], T, size) + chord(bend[k].of[1], T, size);
  if (count == 1) return K[0].least();
  const Form change = K[1] + K[0] * -1.0;
  const double more = std::min(share, 1 - share), apart = std::sqrt(d[0] * d[0] + d[1] * d[1]);
  const Form across = Form{d[0] * d[0], d[0] * d[1], d[1] * d[1]} * (part * more / (apart * T));
  const double lost = std::sqrt(change.ee * change.ee + 2 * change.ef * change.ef + change.ff * change.ff);
  return (K[0] * (1 - share) + K[1] * share + across).least() - part * more * lost;
}

bool ProvenCap::Bent::is_settled(double precision) const {
  constexpr double kUneven = 0.1;  // of the precision: heights of two points that are as high
  return off_size() < precision * mean && uneven() < kUneven * precision * mean;
}

bool ProvenCap::find_bent(const DepthPoint<double>* const* corner, const Vector3& n, double most,
                          double tolerance, DepthOracle<double>& oracle) {
  constexpr int kMostSteps = 6;
  Bent bent;
  corner_[0] = *corner[0];
  for (int k = 1; k < 3; ++k) {
    if (is_same(*corner[k], corner_[0])) continue;
    corner_[1] = *corner[k];
    bent.count = 2;
  }
  n_ = n;
  for (int step = 0;; ++step) {
    oracle.follow(n_, corner_, bent.count);
    bent.look(n_, corner_, oracle);
    if (!(bent.mean <= most * (1 + tolerance) && bent.mean > 0)) return false;
    if (bent.is_settled(tolerance)) return measure_bent(bent, oracle.size(), oracle.error());
    if (step == kMostSteps || !bent.step(n_)) return false;
  }
}

// For the widest T of a few.
bool ProvenCap::measure_bent(const Bent& bent, double size, double error) noexcept {
  constexpr double kMargin = 1 + 1e-6, kRoom = 0.02;  // of the mean: far more than rounding
  constexpr double kTangents[] = {0.6, 0.4, 0.28, 0.2, 0.14, 0.1, 0.07};
  constexpr double kParts[] = {1, 0.5, 0.25, 0.125};
  const double off = bent.off_size() + kRounding * size;
  for (const double T : kTangents) {
    for (const double part : std::span(kParts).first(bent.count == 2 ? 4 : 1)) {
      const double room = 4 * bent.least_of(T, size, part) - 2 * bent.mean * kMargin;
      if (!(room > kRoom * bent.mean)) continue;
      height_ = (bent.mean - bent.uneven() - off * off / room) * (1 - 0x1p-48) - error * (1 + 0x1p-48);
      cosine_ = 1 / std::sqrt(1 + T * T) + 1e-9;
      share_ = bent.share;
      is_bent_ = true;
      return height_ > 0;
    }
  }
  return false;
}

}  // namespace raygauge

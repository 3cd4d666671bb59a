// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/arc_depth.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace raygauge {
namespace {

constexpr double kRounding = 64 * 0x1p-53;  // of products of lengths up to the size
constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

bool ArcDepth::set_edge(const Vector3& edge, const Vector3& first, const Vector3& corner) noexcept {
  constexpr double kLeast = 1e-6;
  const Vector3 across = first - edge * dot(edge, first);
  const double size = length(across);
  if (!(size > kLeast)) return false;
  basis_[0] = across * (1 / size);
  basis_[1] = cross(edge, basis_[0]);
  corner_ = corner;
  for (int i = 0; i < 2; ++i) q_[i] = dot(corner, basis_[i]);
  edge_z_ = edge.z * edge.z;
  return true;
}

ArcDepth::End ArcDepth::look(double x, double y, bool is_top) noexcept {
  ++looks_;
  const Vector3 u = basis_[0] * x + basis_[1] * y;
  const Vector3 rim = frustum_.point(u, is_top);
  End end{};
  end.x = x;
  end.y = y;
  end.p = q_[0] + dot(rim, basis_[0]);
  end.q = q_[1] + dot(rim, basis_[1]);
  end.height = end.p * x + end.q * y;
  end.z = u.z;
  end.rho = std::sqrt(u.x * u.x + u.y * u.y);
  return end;
}

Vector3 ArcDepth::normal() const noexcept { return basis_[0] * best_.x + basis_[1] * best_.y; }

void ArcDepth::keep(const End& end, bool is_top, bool is_inside) noexcept {
  if (!(end.height < height_)) return;
  height_ = end.height;
  best_ = end;
  is_top_ = is_top;
  is_inside_ = is_inside;
}

// The least R(u): where |u_z| is least.
double ArcDepth::curvature_of(const Piece& piece) const noexcept {
  const End &one = piece.end[0], &two = piece.end[1];
  const double rho = one.z * two.z < 0 ? 1.0 : std::max(one.rho, two.rho);
  const double radius = piece.is_top ? frustum_.top : frustum_.base;
  return std::min(radius * edge_z_ * (1 - kRounding), size_ * (rho * rho * rho)) / (rho * rho * rho);
}

// Of x u_x + y u_y over the directions of the piece.
double ArcDepth::least_of(double x, double y, const Piece& piece) noexcept {
  const End &one = piece.end[0], &two = piece.end[1];
  const bool is_between =
      one.y * x - one.x * y >= 0 && two.x * y - two.y * x >= 0;  // the direction against it
  return is_between ? -std::sqrt(x * x + y * y) : std::min(x * one.x + y * one.y, x * two.x + y * two.y);
}

// And the direction in which that is least.
double ArcDepth::bound(const Piece& piece, double& x, double& y) const noexcept {
  const End &one = piece.end[0], &two = piece.end[1];
  const double k = curvature_of(piece);
  const double p = one.p - k * one.x, q = one.q - k * one.y;
  const double r = two.p - k * two.x, s = two.q - k * two.y;
  const double dx = r - p, dy = s - q, square = dx * dx + dy * dy, lost = kRounding * size_;
  x = one.x + two.x;
  y = one.y + two.y;
  const double turn = p * s - q * r;
  if (turn >= 0 && one.height >= k && two.height >= k) {
    const double of_one = std::min(one.height - k, p * two.x + q * two.y),
                 of_two = std::min(two.height - k, r * one.x + s * one.y), ends = std::max(of_one, of_two);
    if (!(square > 0)) return k + ends - lost;
    const double scale = 1 / std::sqrt(square);
    x = dy * scale;
    y = -dx * scale;
    const double line = (turn - kRounding * size_ * size_) * scale;
    return k + std::max(ends, std::min({line, one.height - k, two.height - k})) - lost;
  }
  const double t = square > 0 ? std::clamp(-(p * dx + q * dy) / square, 0.0, 1.0) : 0.0;
  const double fx = p + t * dx, fy = q + t * dy;
  if (fx * fx + fy * fy > 0) {
    x = -fx;
    y = -fy;
  }
  return k + std::max({least_of(fx, fy, piece), least_of(p, q, piece), least_of(r, s, piece)}) - lost;
}

// Beside an end, or beyond it, the middle is taken.
bool ArcDepth::halve(const Piece& whole, double upper, double gap) noexcept {
  constexpr double kBeside = 1e-4;
  Piece left[kMostPieces];
  int count = 1;
  left[0] = whole;
  while (count > 0) {
    const Piece piece = left[--count];
    const End &one = piece.end[0], &two = piece.end[1];
    double x = 0, y = 0;
    const double least = bound(piece, x, y);
    if (least >= std::min(upper, height_) * (1 - gap)) {
      lower_ = std::min(lower_, least);
      continue;
    }
    if (looks_ >= kMostLooks || count + 2 > kMostPieces) return false;
    const double from_one = one.x * y - one.y * x, to_two = x * two.y - y * two.x,
                 beside = kBeside * (one.x * two.y - one.y * two.x);
    if (!(from_one > beside && to_two > beside)) {
      x = one.x + two.x;
      y = one.y + two.y;
    }
    const double scale = 1 / std::sqrt(x * x + y * y);
    const End middle = look(x * scale, y * scale, piece.is_top);
    keep(middle, piece.is_top, true);
    if (!(height_ > 0)) return false;
    left[count++] = {{middle, two}, piece.is_top};
    left[count++] = {{one, middle}, piece.is_top};
  }
  return true;
}

// With the normals of the frustum's side, u_z = along: where the highest rim is another one.
int ArcDepth::list_crossings(double x_1, double y_1, double x_2, double y_2,
                             double (&at)[2][2]) const noexcept {
  const double zx = basis_[0].z, zy = basis_[1].z, square = zx * zx + zy * zy;
  const double rest = square - frustum_.along * frustum_.along;
  if (!(rest > 0)) return 0;
  const double by = std::sqrt(rest);
  int count = 0;
  for (const double sign : {-1.0, 1.0}) {
    const double x = (zx * frustum_.along - sign * by * zy) / square,
                 y = (zy * frustum_.along + sign * by * zx) / square;
    if (!(x_1 * y - y_1 * x > 0 && x * y_2 - y * x_2 > 0)) continue;
    const double scale = 1 / std::sqrt(x * x + y * y);
    at[count][0] = x * scale;
    at[count++][1] = y * scale;
  }
  if (count == 2 && at[0][0] * at[1][1] - at[0][1] * at[1][0] < 0) std::swap(at[0], at[1]);
  return count;
}

bool ArcDepth::search(double x_1, double y_1, double x_2, double y_2, double upper, double gap) noexcept {
  lower_ = height_ = kInfinite;
  double at[2][2];
  const int crossings = list_crossings(x_1, y_1, x_2, y_2, at);
  double x = x_1, y = y_1;
  for (int i = 0; i <= crossings; ++i) {
    const double to_x = i < crossings ? at[i][0] : x_2, to_y = i < crossings ? at[i][1] : y_2;
    Piece piece{};
    const double middle_x = x + to_x, middle_y = y + to_y;
    const double middle_z = basis_[0].z * middle_x + basis_[1].z * middle_y;
    piece.is_top = middle_z > frustum_.along * std::sqrt(middle_x * middle_x + middle_y * middle_y);
    piece.end[0] = look(x, y, piece.is_top);
    piece.end[1] = look(to_x, to_y, piece.is_top);
    for (const End& end : piece.end) keep(end, piece.is_top, false);
    if (!(height_ > 0) || !halve(piece, upper, gap)) return false;
    x = to_x;
    y = to_y;
  }
  return true;
}

void ArcDepth::settle() noexcept {
  constexpr int kMostSteps = 6;
  constexpr double kSettled = 1e-15, kLongest = 0.1;
  for (int step = 0; is_inside_ && step < kMostSteps; ++step) {
    const double off = best_.q * best_.x - best_.p * best_.y, curve = bend(), turn = -off / curve;
    if (!(curve > 0 && std::fabs(turn) < kLongest)) return;
    const double x = best_.x - turn * best_.y, y = best_.y + turn * best_.x;
    const double scale = 1 / std::sqrt(x * x + y * y);
    const End next = look(x * scale, y * scale, is_top_);
    if (!(next.height <= best_.height)) return;
    best_ = next;
    height_ = next.height;
    if (std::fabs(turn) < kSettled) return;
  }
}

}  // namespace raygauge

#include "removal/turning/threads/thread_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

constexpr double kOnBoundary = 1e-9;  ///< mm: the gradient is that of the side
/// Sides that meet at less than 1 degree are one face.
const double kSmoothCos = std::cos(degToRad(1.0));
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

ThreadOutline::ThreadOutline(const ConvexOutline& outline) : min_(outline.min()), max_(outline.max()) {
  for (const OutlineSide& s : outline.sides()) {
    Side side{s.arc,         s.from, s.to, Vec2::UnitX(), Vec2::UnitX(), 0.0, s.center, s.radius,
              Vec2::UnitX(), -1.0,   0};
    const Vec2 chord = s.to - s.from;
    side.length = chord.norm();
    if (side.length > 0.0) side.along = chord / side.length;
    side.normal = {side.along.y(), -side.along.x()};
    if (s.arc) {
      const double begin = std::atan2(s.from.y() - s.center.y(), s.from.x() - s.center.x());
      double sweep = std::atan2(s.to.y() - s.center.y(), s.to.x() - s.center.x()) - begin;
      if (sweep <= 0.0) sweep += 2.0 * kPi;
      side.middle = {std::cos(begin + 0.5 * sweep), std::sin(begin + 0.5 * sweep)};
      side.cos_half = std::cos(0.5 * sweep);
    }
    sides_.push_back(side);
  }
  numberFaces();
}

void ThreadOutline::numberFaces() {
  const std::size_t count = sides_.size();
  std::vector<std::uint8_t> sharp(count);  // where the side begins
  for (std::size_t i = 0; i < count; ++i) {
    const int before = static_cast<int>((i + count - 1) % count);
    const Vec2& p = sides_[i].from;
    sharp[i] = normalAt(before, p).dot(normalAt(static_cast<int>(i), p)) < kSmoothCos;
  }
  const auto first =
      static_cast<std::size_t>(std::find(sharp.begin(), sharp.end(), std::uint8_t{1}) - sharp.begin());
  int face = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (first + k) % count;
    if (k > 0 && sharp[i] != 0) ++face;
    sides_[i].face = face;
  }
}

double ThreadOutline::distanceTo(const Side& side, const Vec2& p) {
  if (side.arc) {
    const Vec2 arm = p - side.center;
    const double length = arm.norm();
    if (side.holds(arm, length)) return std::abs(length - side.radius);
  } else if (const double along = side.along.dot(p - side.from); along >= 0.0 && along <= side.length) {
    return std::abs(side.normal.dot(p - side.from));
  }
  return std::min((p - side.from).norm(), (p - side.to).norm());
}

ThreadOutline::Face ThreadOutline::nearFace(int face, const Vec2& p) const {
  const Side* nearest = nullptr;
  double least = kInfinity;
  for (const Side& side : sides_) {
    if (side.face != face) continue;
    const double distance = distanceTo(side, p);
    if (distance >= least) continue;
    least = distance;
    nearest = &side;
  }
  if (nearest == nullptr) return {kInfinity, Vec2::UnitX(), kInfinity};
  if (!nearest->arc) return {nearest->normal.dot(p - nearest->from), nearest->normal, least};
  const Vec2 arm = p - nearest->center;
  const double length = arm.norm();
  return {length - nearest->radius, length > 0.0 ? Vec2(arm / length) : nearest->middle, least};
}

ThreadOutline::Near ThreadOutline::near(const Vec2& p) const {
  Near best{kInfinity, Vec2::UnitX(), 0};
  bool inside = true;
  double least = kInfinity;
  Vec2 corner = p;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const Side& side = sides_[k];
    const Vec2 from = p - side.from;
    double distance = kInfinity;
    Vec2 normal = side.normal, foot = side.from;
    bool on_side = false;
    if (side.arc) {
      const Vec2 arm = p - side.center;
      const double length = arm.norm();
      on_side = side.holds(arm, length) && length > 0.0;
      if (on_side) {
        distance = std::abs(length - side.radius);
        normal = arm / length;
      } else {
        normal = length > 0.0 ? Vec2(arm / length) : side.middle;
      }
      if (side.normal.dot(from) > 0.0 && length > side.radius) inside = false;
    } else {
      const double along = side.along.dot(from), out = side.normal.dot(from);
      on_side = along >= 0.0 && along <= side.length;
      if (on_side) distance = std::abs(out);
      if (out > 0.0) inside = false;
    }
    if (!on_side) {
      const double to_from = from.norm(), to_to = (p - side.to).norm();
      distance = std::min(to_from, to_to);
      foot = to_from <= to_to ? side.from : side.to;
    }
    if (distance >= least) continue;
    least = distance;
    corner = foot;
    best = {distance, normal, static_cast<int>(k)};
    if (!on_side && distance > kOnBoundary) best.gradient = Vec2::Zero();  // a corner: by the point below
  }
  best.value = inside ? -least : least;
  if (best.gradient.isZero()) best.gradient = (p - corner) / best.value;
  return best;
}

ThreadOutline::Span ThreadOutline::spanAt(double r) const {
  Span span{kInfinity, -kInfinity, 0, 0};
  const auto add = [&](double z, std::size_t side) {
    if (z < span.low) {
      span.low = z;
      span.low_side = static_cast<int>(side);
    }
    if (z > span.high) {
      span.high = z;
      span.high_side = static_cast<int>(side);
    }
  };
  if (!(r >= min_.x() && r <= max_.x())) return span;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const Side& side = sides_[k];
    if (!side.arc) {
      if ((side.from.x() > r) == (side.to.x() > r)) continue;
      add(side.from.y() + (r - side.from.x()) / (side.to.x() - side.from.x()) * (side.to.y() - side.from.y()),
          k);
      continue;
    }
    const double dr = r - side.center.x();
    const double square = side.radius * side.radius - dr * dr;
    if (square < 0.0) continue;
    for (const double dz : {-std::sqrt(square), std::sqrt(square)}) {
      if (side.holds({dr, dz}, side.radius)) add(side.center.y() + dz, k);
    }
  }
  return span;
}

Vec2 ThreadOutline::normalAt(int side, const Vec2& p) const {
  const Side& s = sides_[static_cast<std::size_t>(side)];
  if (!s.arc) return s.normal;
  const Vec2 arm = p - s.center;
  return arm.norm() > 0.0 ? Vec2(arm.normalized()) : s.middle;
}

}  // namespace proveout

#include "removal/sweep/kinds/curve_bodies.h"

#include <algorithm>
#include <cmath>

#include "removal/sweep/column_curve.h"
#include "removal/sweep/column_interval.h"
#include "removal/sweep/column_way.h"

namespace proveout {

namespace {

/// A turn that rises by no more than this part of its way is as good as level.
constexpr double kLevel = 1e-4;

/// A step that leaves less than this share of the value was worth it. Behind one this short from a value this
/// small, mm, what is left is its square.
constexpr double kWorth = 0.5, kLastStepMm = 1e-7, kNearMm = 1e-6;
/// Values that count as 0, and edges as short as a point, mm.
constexpr double kZeroMm = 1e-10, kPointMm = 1e-9;

/// Newton's method from the end inside, where the slopes lead, and else the Illinois rule as edgeRoot.
template <typename Way>
class CurveRoot {
 public:
  CurveRoot(const Way& part, const Vec3& a, double dx, double dy, double inside)
      : part_(part), a_(a), dx_(dx), dy_(dy), in_(inside) {}

  struct Found {
    double at, place;
  };
  Found find() {
    CurveSide side = look(in_);
    if (side.value >= 0.0) return {in_, side.place};
    f_in_ = side.value;
    double t = in_;
    for (int round = 0; round < kMostRounds; ++round) {
      const double before = std::abs(side.value);
      double next = side.slope != 0.0 ? t - side.value / side.slope : kNoHeight;
      if (std::abs(next - t) < kLastStepMm && before < kNearMm)
        return {std::clamp(next, 0.0, in_), side.place};
      if (!worth_ || !(next > out_ && next < in_)) {
        if (!out_known_ && !lookAtStart()) return {0.0, start_place_};
        next = (f_out_ * in_ - f_in_ * out_) / (f_out_ - f_in_);
        if (round > kMostIllinois || !(next > out_ && next < in_)) next = 0.5 * (out_ + in_);
      }
      t = next;
      side = look(t);
      if (std::abs(side.value) < kZeroMm) break;
      worth_ = std::abs(side.value) < kWorth * before;
      narrow(t, side.value);
      if (out_known_ && in_ - out_ < kPointMm) break;
    }
    return {t, side.place};
  }

 private:
  static constexpr int kMostRounds = 100, kMostIllinois = 20;

  CurveSide look(double t) const {
    return curveSide(part_, {a_.x() + t * dx_, a_.y() + t * dy_, a_.z()}, dx_, dy_);
  }
  /// False where the start is inside within rounding.
  bool lookAtStart() {
    const CurveSide start = look(0.0);
    out_known_ = true;
    f_out_ = start.value;
    start_place_ = start.place;
    return start.value > 0.0;
  }
  void narrow(double t, double value) {
    if (value >= 0.0) {
      out_ = t, f_out_ = value, out_known_ = true;
      if (side_ == 1) f_in_ *= 0.5;
      side_ = 1;
    } else {
      in_ = t, f_in_ = value;
      if (side_ == -1) f_out_ *= 0.5;
      side_ = -1;
    }
  }

  const Way& part_;
  const Vec3& a_;
  double dx_, dy_, in_, out_ = 0.0, f_in_ = 0.0, f_out_ = 0.0, start_place_ = 0.0;
  bool out_known_ = false, worth_ = true;
  int side_ = 0;
};

template <typename Body>
EdgeCut cutOf(const Body& body, const BodyContext& of, const Vec3& a, double dx, double dy, double inside) {
  const auto cut = CurveRoot(body.way, a, dx, dy, inside).find();
  return {cut.at, body.startOf(of, cut.place)};
}

template <typename Body>
double startBeside(const Body& body, const BodyContext& of, const Vec3& p) {
  return body.startOf(of, curveSide(body.way, {p.x(), p.y(), p.z()}, 0.0, 0.0).place);
}

}  // namespace

void TurnBody::cutEdges(const BodyContext& of, EdgeCuts& cuts) const {
  columnKernels().cuts(way, cuts);
  for (int i = 0; i < cuts.count; ++i) {
    const bool found = cuts.found[i] > 0.0;
    cuts.start[i] = found ? startOf(of, cuts.place[i]) : -1.0;
    if (found || cuts.end[i] != 0.0) continue;
    const Vec3 a(cuts.x[i], cuts.y[i], cuts.z[i]);
    const EdgeCut cut = levelCut(of, a, cuts.dx[i], cuts.dy[i], cuts.inside[i]);
    cuts.at[i] = cut.at, cuts.start[i] = cut.start;
  }
}

double TurnBody::mostDepth(double x, double y) const {
  const double qx = x - way.x, qy = y - way.y;
  return depthBeside(std::abs(std::sqrt(qx * qx + qy * qy) - way.arc_radius));
}

bool TurnBody::holdsEdges(double h, const Vec2& middle, double reach) const {
  const double c = std::cos(way.cut_rad), s = way.turn * std::sin(way.cut_rad);
  const Vec2 u(way.ux, way.uy), cut(c * u.x() - s * u.y(), s * u.x() + c * u.y());
  const Vec2 q = middle - Vec2(way.x, way.y);
  const Vec2 nearest = std::max(0.0, q.dot(cut)) * cut;
  if ((q - nearest).squaredNorm() < reach * reach) return false;
  return way.way_rad <= kPi || turnsWithoutPillar(solid(), way.arc_radius, h);
}

EdgeCut TurnBody::levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const {
  return cutOf(*this, of, a, dx, dy, inside);
}

double TurnBody::startAt(const BodyContext& of, const Vec3& p) const { return startBeside(*this, of, p); }

/// A level arc whose end is off its circle by the rounding of a program's digits is a turn.
Vec3 TurnBody::directionAt(const Vec3& p) const {
  if (std::abs(way.slope) >= kLevel * way.arc_radius) return Vec3::Zero();
  return directionAround(way.x, way.y, way.turn, p);
}

double UprightBody::mostDepth(double x, double y) const {
  const double qx = x - way.x, qy = y - way.y;
  const double along = qx * way.ux + qy * way.uy, across = qx * way.uy - qy * way.ux;
  const double beyond = along - std::clamp(along, way.first_mm, way.last_mm);
  return depthBeside(std::sqrt(across * across + beyond * beyond));
}

EdgeCut UprightBody::levelCut(const BodyContext& of, const Vec3& a, double dx, double dy,
                              double inside) const {
  return cutOf(*this, of, a, dx, dy, inside);
}

double UprightBody::startAt(const BodyContext& of, const Vec3& p) const { return startBeside(*this, of, p); }

double UprightBody::startOf(const BodyContext& of, double place) const {
  const double high = std::sqrt(std::max(0.0, (way.arc_radius - place) * (way.arc_radius + place)));
  return of.whole->parameterAt(
      Vec3(way.x + place * way.ux, way.y + place * way.uy, way.start_z + way.side * high));
}

double WayBody::mostDepth(double x, double y) const { return depthBeside(wayGap(way, x, y)); }

EdgeCut WayBody::levelCut(const BodyContext& of, const Vec3& a, double dx, double dy, double inside) const {
  return cutOf(*this, of, a, dx, dy, inside);
}

double WayBody::startOf(const BodyContext&, double place) const {
  return std::clamp(place / way.way->way_rad, 0.0, 1.0);
}

double WayBody::startAt(const BodyContext& of, const Vec3& p) const { return startBeside(*this, of, p); }

}  // namespace proveout

#include "removal/sweep/kinds/lean_arc_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "removal/sweep/kinds/line_meeting.h"
#include "removal/sweep/leaning_sweep.h"

namespace proveout {

namespace {

using Element = ConvexProfile::Element;
using Polynomial = std::array<double, 5>;  ///< by growing powers

/// Pieces are no longer than this, and leave their chord by no more than this share of the tool's radius.
constexpr double kMostPieceRad = 1.6, kSagittaShare = 0.25, kMostPieces = 1e4;
/// Meetings nearer to each other than this are one, mm.
constexpr double kOneMm = 1e-11;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double valueAt(const Polynomial& c, int degree, double t) {
  double value = c[static_cast<std::size_t>(degree)];
  for (int i = degree; i-- > 0;) value = value * t + c[static_cast<std::size_t>(i)];
  return value;
}

/// Places of a line where it may come into the volume, in growing order when they are sorted.
class Meetings {
 public:
  Meetings(double low, double high) : low_(low), high_(high) {}

  void add(double t) {
    if (t >= low_ && t <= high_ && count_ < places_.size()) places_[count_++] = t;
  }
  void add(const QuadraticRoots& roots) { add(roots.low), add(roots.high); }
  /// The roots at which a polynomial changes its sign: between those of its derivative there is one at most.
  void addRoots(const Polynomial& c, int degree) {
    std::array<double, 5> stops;
    const int count = roots(c, degree, stops);
    for (int i = 0; i < count; ++i) add(stops[static_cast<std::size_t>(i)]);
  }
  std::span<const double> sorted() {
    std::sort(places_.begin(), places_.begin() + static_cast<std::ptrdiff_t>(count_));
    return {places_.data(), count_};
  }

 private:
  static constexpr int kMostRounds = 200;

  int roots(const Polynomial& c, int degree, std::array<double, 5>& out) const {
    if (degree == 0) return 0;
    Polynomial slope{};
    for (int i = 0; i < degree; ++i)
      slope[static_cast<std::size_t>(i)] = (i + 1) * c[static_cast<std::size_t>(i) + 1];
    std::array<double, 5> turns;
    const int count = roots(slope, degree - 1, turns);
    int found = 0;
    double from = low_, at_from = valueAt(c, degree, from);
    for (int i = 0; i <= count; ++i) {
      const double to = i == count ? high_ : turns[static_cast<std::size_t>(i)];
      const double at_to = valueAt(c, degree, to);
      if ((at_from < 0.0) != (at_to < 0.0))
        out[static_cast<std::size_t>(found++)] = root(c, slope, degree, from, to, at_from < 0.0);
      from = to, at_from = at_to;
    }
    return found;
  }
  /// Newton's method within a bracket, else halves of it. `rises`: below 0 at `from`.
  static double root(const Polynomial& c, const Polynomial& slope, int degree, double from, double to,
                     bool rises) {
    double t = 0.5 * (from + to);
    for (int round = 0; round < kMostRounds; ++round) {
      const double value = valueAt(c, degree, t), rate = valueAt(slope, degree - 1, t);
      ((value < 0.0) == rises ? from : to) = t;
      double next = t - value / rate;
      if (!(next > from && next < to)) next = 0.5 * (from + to);
      if (next == t || std::abs(next - t) < 1e-15 * std::abs(t)) break;
      t = next;
    }
    return t;
  }

  double low_, high_;
  std::array<double, 136> places_;
  std::size_t count_ = 0;
};

/// A line as seen from the axis of a solid of revolution: heights and squares of level distances.
struct AxisView {
  AxisView(const SpaceLine& line, const Vec3& axis_at) {
    const Vec3 q = line.from - axis_at;
    z = q.z(), rise = line.along.z();
    level2 = q.head<2>().squaredNorm();
    turn = q.head<2>().dot(line.along.head<2>());
    step2 = line.along.head<2>().squaredNorm();
  }
  double z, rise;              ///< height: z + rise t
  double level2, turn, step2;  ///< level distance: its square is level2 + 2 turn t + step2 t^2
};

/// What of the line is in a cylinder about the axis.
ColumnSpan inCylinder(const AxisView& v, double wide, double low, double high) {
  constexpr double kNone = 1e-300, kFar = std::numeric_limits<double>::infinity();
  const double beyond = v.level2 - wide * wide, root2 = v.turn * v.turn - v.step2 * beyond;
  if (!(v.step2 > kNone ? root2 > 0.0 : beyond < 0.0)) return {};
  const double root = std::sqrt(root2);
  const ColumnSpan span = v.step2 > kNone ? ColumnSpan{(-v.turn - root) / v.step2, (-v.turn + root) / v.step2}
                                          : ColumnSpan{-kFar, kFar};
  if (std::abs(v.rise) < kNone) return v.z > low && v.z < high ? span : ColumnSpan{};
  const double one = (low - v.z) / v.rise, other = (high - v.z) / v.rise;
  return {std::max(span.lo, std::min(one, other)), std::min(span.hi, std::max(one, other))};
}

/// The level faces of all places of the way.
void addLevels(const AxisView& v, const ConvexProfile& profile, Meetings& to) {
  for (int i = 0; i < profile.elementCount(); ++i) {
    const Element& e = profile.element(i);
    if (!e.arc && e.dz == 0.0) to.add((e.az - v.z) / v.rise);
  }
}

void addStraight(const AxisView& v, const Element& e, double out, double side, Meetings& to) {
  // distance * dz = out dz +- (ar dz + (height - az) dr)
  const double at = out * e.dz + side * (e.ar * e.dz + (v.z - e.az) * e.dr), grows = side * e.dr * v.rise;
  const double dz2 = e.dz * e.dz;
  to.add(quadraticRoots(dz2 * v.step2 - grows * grows, dz2 * v.turn - at * grows, dz2 * v.level2 - at * at));
}

/// A ring: (distance - out)^2 + (height - cz)^2 = radius^2.
void addRing(const AxisView& v, const Element& e, double out, Meetings& to) {
  const double up = v.z - e.cz, r2 = e.radius * e.radius;
  if (out == 0.0) {
    to.add(quadraticRoots(v.step2 + v.rise * v.rise, v.turn + up * v.rise, v.level2 + up * up - r2));
    return;
  }
  // The sum of the squares less what is constant; then its square less that of 2 out distance.
  const double a = v.step2 + v.rise * v.rise, b = v.turn + up * v.rise,
               c = v.level2 + up * up + out * out - r2;
  const double four = 4.0 * out * out;
  to.addRoots({c * c - four * v.level2, 4.0 * b * c - 2.0 * four * v.turn,
               2.0 * a * c + 4.0 * b * b - four * v.step2, 4.0 * a * b, a * a},
              4);
}

/// The faces, but for level ones, of a solid of revolution whose profile, or its mirror image (side -1),
/// begins `out` from the axis.
void addFaces(const AxisView& v, const ConvexProfile& profile, double out, double side, Meetings& to) {
  for (int i = 0; i < profile.elementCount(); ++i) {
    const Element& e = profile.element(i);
    if (e.arc) {
      addRing(v, e, out + side * e.cr, to);
    } else if (e.dz != 0.0) {
      addStraight(v, e, out, side, to);
    }
  }
}

}  // namespace

LeanArc::LeanArc(const ConvexProfile& of, const ToolFrame& in, const Vec3& from, const Vec3& to,
                 const ArcGeometry& arc, const PoseSolid& known)
    : bounds(LeaningSweep(of, in, from, to, &arc).bounds()), solid(&known), profile(&of), frame(in) {
  const Vec3 start = in.toTool(from), end = in.toTool(to);
  center = in.toTool(arc.center);
  center.z() = start.z();
  const Vec2 a = (start - center).head<2>(), b = (end - center).head<2>();
  radius = 0.5 * (a.norm() + b.norm());
  first = a.normalized(), last = b.normalized();
  turn = arc.sweep_rad * in.toTool(arc.normal).z() < 0.0 ? -1.0 : 1.0;
  if (turn < 0.0) std::swap(first, last);
  sweep = std::abs(arc.sweep_rad);
  setPlace();
}

void LeanArc::cut(std::deque<LeanArc>& out) const {
  const double step = std::min(kMostPieceRad, std::sqrt(8.0 * kSagittaShare * profile->maxRadius() / radius));
  const int count = static_cast<int>(std::ceil(std::clamp(sweep / step, 1.0, kMostPieces)));
  const double angle = sweep / count;
  Vec2 from = first;
  for (int i = 0; i < count; ++i) {
    LeanArc& piece = out.emplace_back(*this);
    piece.first = from;
    if (i + 1 < count) piece.last = Eigen::Rotation2Dd((i + 1) * angle) * first;
    piece.sweep = angle;
    piece.setPlace();
    from = piece.last;
  }
}

/// Where the ends are known, all else follows.
void LeanArc::setPlace() {
  id_ = nextPieceId();
  const auto toPart = [&](const Vec2& level) { return frame.toPart(Vec3(level.x(), level.y(), 0.0)); };
  const Vec2 from = radius * first, to = radius * last, way = to - from;
  chord = axialView(poseAt(frame.toPart(center) + toPart(from), frame.axis()), toPart(way));
  sagitta = sweep < kPi ? radius * (1.0 - std::cos(0.5 * sweep)) : 2.0 * radius;
  // On the inner side of the chord nothing is farther from it than the tool's radius; between the ends the
  // tool covers what is nearer than where its circles at the ends meet.
  const double least = thinnestPart(*profile), half = 0.5 * way.norm();
  const double near = least > half ? std::sqrt(least * least - half * half) : -sagitta;
  const Vec3 inner = toPart(-(from + to).stableNormalized());
  const double inner_q = inner.x() * chord.qx + inner.y() * chord.qy, near_q = near * inner_q,
               far_q = profile->maxRadius() * inner_q;
  notch_low = std::min(near_q, far_q) + chord.low_q - kCullSlackMm;
  notch_high = std::max(near_q, far_q) + chord.high_q + kCullSlackMm;
}

void LeanArc::reach(int number, const FourBlocks& blocks, double* low, double* high) const {
  columnKernels().pose_reach(span(), blocks, low, high);
  for (int i = 0; number > 0 && i < 4; ++i) {
    if (meetsNotch(blocks.x[i], blocks.y[i], blocks.half_width)) continue;
    low[i] = std::numeric_limits<double>::infinity(), high[i] = -low[i];
  }
}

ColumnSpan LeanArc::column(double x, double y, int number) const {
  if (x < bounds.min.x() || x > bounds.max.x() || y < bounds.min.y() || y > bounds.max.y()) return {};
  if (!meetsNotch(x, y, 0.0)) return number == 0 ? columnSpans(x, y)[0] : ColumnSpan{};
  return keptSpans(*this, id_, x, y)[static_cast<std::size_t>(number)];
}

/// Seen along the axis, a column is a line at one q.
bool LeanArc::meetsNotch(double x, double y, double half_width) const {
  if (sweep > kMostPieceRad) return true;
  const double q = (x - chord.at.x) * chord.qx + (y - chord.at.y) * chord.qy;
  const double beside = half_width * (std::abs(chord.qx) + std::abs(chord.qy));
  return q + beside > notch_low && q - beside < notch_high;
}

LeanArc::Spans LeanArc::columnSpans(double x, double y) const {
  // Counted from where the line is nearest to the centre, so that powers stay small.
  const Vec3 along = frame.toTool(Vec3::UnitZ());
  SpaceLine line{frame.toTool(Vec3(x, y, 0.0)) - center, along};
  const double base = -line.from.dot(along);
  line.from += base * along;
  const AxisView around(line, Vec3::Zero());
  const ColumnSpan all = inCylinder(around, radius + profile->maxRadius() + kOneMm, profile->zMin() - kOneMm,
                                    profile->zMax() + kOneMm);
  if (!(all.lo < all.hi)) return {};

  Meetings meetings(all.lo, all.hi);
  addLevels(around, *profile, meetings);
  addFaces(around, *profile, radius, 1.0, meetings);
  addFaces(around, *profile, radius, -1.0, meetings);
  std::array<Vec3, 2> ends{Vec3::Zero(), Vec3::Zero()};
  ends[0].head<2>() = radius * first, ends[1].head<2>() = radius * last;
  for (const Vec3& end : ends) addFaces(AxisView(line, end), *profile, 0.0, 1.0, meetings);

  const auto covers = [&](const Vec3& p) {
    const Vec2 level = p.head<2>();
    const double off = isPassed(level)
                           ? std::abs(level.norm() - radius)
                           : std::min((p - ends[0]).head<2>().norm(), (p - ends[1]).head<2>().norm());
    return profile->sample(off, p.z()).value < 0.0;
  };
  Spans spans;
  std::size_t count = 0;
  bool open = false;
  double before = -std::numeric_limits<double>::infinity();
  for (const double t : meetings.sorted()) {
    if (t - before > kOneMm) {
      const bool in = before >= all.lo && covers(line.at(0.5 * (before + t)));
      if (in && !open) spans[count].lo = before + base;
      if (!in && open) {
        spans[count].hi = before + base;
        if (++count == spans.size()) return spans;
      }
      open = in;
    }
    before = t;
  }
  if (open) spans[count].hi = before + base;
  return spans;
}

bool LeanArc::isPassed(const Vec2& level) const {
  if (sweep >= 2.0 * kPi) return true;
  if (sweep <= kPi) return cross(first, level) >= 0.0 && cross(level, last) >= 0.0;
  return !(cross(last, level) > 0.0 && cross(level, first) > 0.0);
}

std::optional<double> LeanArcBody::simpleBend(const ConvexProfile::Element& e) const {
  if (e.arc) return std::nullopt;
  if (e.dz == 0.0) return 0.0;
  if (e.dr != 0.0) return std::nullopt;
  return wallBend(e.ar, std::abs(arc->radius - e.ar));
}

Vec3 LeanArcBody::directionAt(const Vec3& p) const {
  const Vec3 q = arc->frame.toTool(p) - arc->center;
  return arc->frame.toPart(arc->turn * Vec3(-q.y(), q.x(), 0.0).stableNormalized());
}

}  // namespace proveout

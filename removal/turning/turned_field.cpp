#include "removal/turning/turned_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "removal/grid/edge_root.h"
#include "removal/turning/section/section_field.h"
#include "removal/turning/threads/thread_field.h"

namespace proveout {

namespace {

/// Faces of the section have the lower half of the numbers, those of threads the upper one: 64 for each, two
/// for each face of the outline.
constexpr int kThreadFaces = 0x8000, kFacesOfThread = 64, kThreads = kThreadFaces / kFacesOfThread;

int sectionFace(const SectionField::Edge& e) { return e.face % kThreadFaces; }
int threadFace(const HelixSweep& s, int face, double t) {
  return kThreadFaces + s.number() % kThreads * kFacesOfThread + 2 * std::min(face, HelixSweep::kEndFace) +
         s.parityAt(t);
}

Vec3 turnedNormal(const Vec2& n, double phi) { return {n.x() * std::cos(phi), n.x() * std::sin(phi), n.y()}; }

class TurnedField : public BlankField {
 public:
  TurnedField(const TurnedShape& shape)
      : section_(shape.bodies), threads_(shape.threads, section_.min(), section_.max()) {}

  BlankSample sample(const Vec3& p) const override;
  double value(const Vec3& p) const override;
  Box3 bounds() const override;
  double volume() const override { return section_.volume(); }
  LeafBits material(const Vec3& first, double h) const override;
  EdgeHit edgeHit(const Vec3& start, int axis, double length, bool inside) const override;
  std::optional<FacePoint> facePoint(std::uint64_t face, const Vec3& p, double most) const override;
  bool isSimple(std::uint64_t face) const override;

 private:
  /// A grid edge, walked from its end in the material.
  struct Walk {
    Vec3 from, step;  ///< all of the edge
    int axis;
    Vec3 at(double way) const { return from + way * step; }
  };
  void levelSection(const Walk& walk, double& way, EdgeHit& hit) const;
  void levelThreads(const Walk& walk, double& way, EdgeHit& hit) const;
  void upright(const Walk& walk, double& way, EdgeHit& hit) const;
  EdgeHit atEnd(const Walk& walk, double& way) const;
  EdgeHit sectionHit(int edge, const PolarPoint& p) const;
  void cutThreads(const Vec3& first, double h, const std::array<double, 64>& radius, LeafBits& bits) const;

  std::optional<FacePoint> threadPoint(std::uint64_t face, const Vec3& p, double most) const;

  SectionField section_;
  ThreadField threads_;
};

Box3 TurnedField::bounds() const {
  const double r = section_.max().x();
  return {{-r, -r, section_.min().y()}, {r, r, section_.max().y()}};
}

BlankSample TurnedField::sample(const Vec3& p) const {
  const PolarPoint polar = PolarPoint::of(p);
  const Vec2 q = polar.inPlane();
  const SectionField::Nearest near = section_.nearest(q, 1e300);
  const SectionField::Edge& edge = section_.edge(near.edge);
  const bool inside = section_.inside(q);
  const BlankSample section{inside ? -near.distance : near.distance,
                            turnedNormal(edge.normalAt(near.point), polar.phi), sectionFace(edge),
                            edge.motion};
  const ThreadField::Bound thread = threads_.bound(polar, near.distance);
  // Outside of the section too: where a thread cuts into its face, that is no surface.
  if (thread.sweep == nullptr || -thread.value <= section.value) return section;
  const HelixSweep::Side side = thread.sweep->sideAt(polar, thread.t);
  return {-thread.value, -side.normal, threadFace(*thread.sweep, side.face, thread.t),
          thread.sweep->motion()};
}

double TurnedField::value(const Vec3& p) const {
  const PolarPoint polar = PolarPoint::of(p);
  const double distance = section_.nearest(polar.inPlane(), 1e300).distance;
  const double section = section_.inside(polar.inPlane()) ? -distance : distance;
  return std::max(section, -threads_.bound(polar, distance).value);
}

LeafBits TurnedField::material(const Vec3& first, double h) const {
  std::array<double, 64> radius;
  for (int bit = 0; bit < 64; ++bit) {
    const double x = first.x() + (bit >> 3) * h, y = first.y() + (bit & 7) * h;
    radius[static_cast<std::size_t>(bit)] = std::max(std::sqrt(x * x + y * y), SectionField::kLeastRadius);
  }
  LeafBits bits{};
  std::vector<double> radii;
  for (int z = 0; z < 8; ++z) {
    section_.radiiAt(first.z() + z * h, radii);
    for (const double r : radii) {
      for (int bit = 0; bit < 64; ++bit) {
        bits[static_cast<std::size_t>(z)] ^=
            static_cast<std::uint64_t>(r < radius[static_cast<std::size_t>(bit)]) << bit;
      }
    }
  }
  if (!threads_.empty()) cutThreads(first, h, radius, bits);
  return bits;
}

void TurnedField::cutThreads(const Vec3& first, double h, const std::array<double, 64>& radius,
                             LeafBits& bits) const {
  const auto [least, most] = std::minmax_element(radius.begin(), radius.end());
  const Vec2 low(*least, first.z()), high(*most, first.z() + 7 * h);
  std::array<double, 64> phi;
  bool have_phi = false;
  threads_.forEachNear(low, high, [&](const HelixSweep& sweep) {
    HelixSweep::Window window;
    if (!sweep.window(low, high, window)) return;
    for (int bit = 0; bit < 64 && !have_phi; ++bit) {
      phi[static_cast<std::size_t>(bit)] = std::atan2(first.y() + (bit & 7) * h, first.x() + (bit >> 3) * h);
    }
    have_phi = true;
    for (std::size_t bit = 0; bit < 64; ++bit) {
      sweep.forEachPass(phi[bit], window, [&](double t) {
        const Vec2 tool = sweep.at(t);
        const ThreadOutline::Span span = sweep.outline().spanAt(radius[bit] - tool.x());
        const double from = (span.low + tool.y() - first.z()) / h,
                     to = (span.high + tool.y() - first.z()) / h;
        if (!(from < to) || to <= 0.0 || from >= 7.0) return;
        const int begin = std::max(0, static_cast<int>(std::floor(from)) + 1);
        for (int z = begin; z < 8 && z < to; ++z) bits[static_cast<std::size_t>(z)] &= ~(1ull << bit);
      });
    }
  });
}

BlankField::EdgeHit TurnedField::sectionHit(int edge, const PolarPoint& p) const {
  const SectionField::Edge& e = section_.edge(edge);
  return {0.0, turnedNormal(e.normalAt(p.inPlane()), p.phi), sectionFace(e), e.motion};
}

/// Edges along X or Y: the section's circle at this height is met where x^2 + y^2 = r^2.
void TurnedField::levelSection(const Walk& walk, double& way, EdgeHit& hit) const {
  const double begin = walk.from[walk.axis], step = walk.step[walk.axis], beside = walk.from[1 - walk.axis];
  int edge = -1;
  section_.forEachAtLevel(walk.from.z(), [&](int i, double r) {
    const double square = r * r - beside * beside;
    if (square < 0.0 || section_.edge(i).on_axis) return;
    for (const double at : {std::sqrt(square), -std::sqrt(square)}) {
      const double there = (at - begin) / step;
      if (there < 0.0 || there > 1.0 || there >= way) continue;
      way = there;
      edge = i;
    }
  });
  if (edge >= 0) hit = sectionHit(edge, PolarPoint::of(walk.at(way)));
}

/// Of the passes that take the outer end the one that comes nearest to the material.
void TurnedField::levelThreads(const Walk& walk, double& way, EdgeHit& hit) const {
  const PolarPoint end = PolarPoint::of(walk.at(1.0));
  const HelixSweep* taker = nullptr;
  double taken_at = 0.0;  // the part of the turns at the outer end
  const Vec2 q = end.inPlane();
  threads_.forEachNear(q, q, [&](const HelixSweep& sweep) {
    HelixSweep::Window window;
    if (!sweep.window(q, q, window)) return;
    sweep.forEachPass(end.phi, window, [&](double t) {
      const double at_end = sweep.valueAt(end, t);
      if (!(at_end < 0.0)) return;
      const auto value = [&](double w) {
        const PolarPoint p = PolarPoint::of(walk.at(w));
        return sweep.valueAt(p, t + wrapAngle(p.phi - end.phi) / sweep.turn());
      };
      const double from = std::min(way, 1.0), at_from = from < 1.0 ? value(from) : at_end;
      if (!(at_from < 0.0)) return;  // another face is nearer
      const double at_begin = value(0.0);
      way = at_begin <= 0.0 ? 0.0 : edgeRoot(value, 0.0, at_begin, from, at_from, 1e-9);
      taker = &sweep;
      taken_at = t;
    });
  });
  if (taker == nullptr) return;
  const PolarPoint p = PolarPoint::of(walk.at(way));
  const double t = taken_at + wrapAngle(p.phi - end.phi) / taker->turn();
  const HelixSweep::Side side = taker->sideAt(p, t);
  hit = {0.0, -side.normal, threadFace(*taker, side.face, t), taker->motion()};
}

void TurnedField::upright(const Walk& walk, double& way, EdgeHit& hit) const {
  const PolarPoint begin = PolarPoint::of(walk.from);
  const double step = walk.step.z();
  const Vec2 low(begin.r, std::min(begin.z, begin.z + step)),
      high(begin.r, std::max(begin.z, begin.z + step));
  section_.forEachAtRadius(begin.r, low.y(), high.y(), [&](int edge, double z) {
    const double there = (z - begin.z) / step;
    if (there >= way) return;
    way = there;
    hit = sectionHit(edge, {begin.r, begin.phi, z});
  });
  threads_.forEachNear(low, high, [&](const HelixSweep& sweep) {
    HelixSweep::Window window;
    if (!sweep.window(low, high, window)) return;
    sweep.forEachPass(begin.phi, window, [&](double t) {
      const Vec2 tool = sweep.at(t);
      const double r = begin.r - tool.x();
      const ThreadOutline::Span span = sweep.outline().spanAt(r);
      if (!(span.low < span.high)) return;
      const double near = step > 0.0 ? span.low : span.high;
      const int side = step > 0.0 ? span.low_side : span.high_side;
      const double there = (near + tool.y() - begin.z) / step;
      if (there < 0.0 || there > 1.0 || there >= way) return;
      way = there;
      const Vec3 normal =
          sweep.turned(sweep.outline().normalAt(side, {r, near}), {begin.r, begin.phi, near + tool.y()}, t);
      hit = {0.0, -normal.normalized(), threadFace(sweep, sweep.outline().faceOf(side), t), sweep.motion()};
    });
  });
}

/// Where rounding hides the crossing it is at one of the ends.
BlankField::EdgeHit TurnedField::atEnd(const Walk& walk, double& way) const {
  const BlankSample a = sample(walk.at(0.0)), b = sample(walk.at(1.0));
  way = std::abs(a.value) < std::abs(b.value) ? 0.0 : 1.0;
  const BlankSample& s = way > 0.0 ? b : a;
  return {way, s.normal, s.face};
}

BlankField::EdgeHit TurnedField::edgeHit(const Vec3& start, int axis, double length, bool inside) const {
  const Vec3 whole = Vec3::Unit(axis) * length;
  const Walk walk{inside ? start : Vec3(start + whole), inside ? whole : Vec3(-whole), axis};
  double way = 2.0;
  EdgeHit hit{};
  if (axis == 2) {
    upright(walk, way, hit);
  } else {
    levelSection(walk, way, hit);
    levelThreads(walk, way, hit);
  }
  if (way > 1.0) hit = atEnd(walk, way);
  hit.t = inside ? way : 1.0 - way;
  return hit;
}

bool TurnedField::isSimple(std::uint64_t face) const {
  const auto number = static_cast<int>(face & 0xFFFF);
  return number < std::min(section_.faceCount(), kThreadFaces) && section_.isSimple(number);
}

std::optional<BlankField::FacePoint> TurnedField::facePoint(std::uint64_t face, const Vec3& p,
                                                            double most) const {
  const auto number = static_cast<int>(face & 0xFFFF);
  if (number >= kThreadFaces) return threadPoint(face, p, most);
  if (section_.faceCount() > kThreadFaces) return std::nullopt;  // numbers came again
  const PolarPoint polar = PolarPoint::of(p);
  const SectionField::Nearest near = section_.nearestOn(number, polar.inPlane(), most);
  if (near.edge < 0) return std::nullopt;
  const Vec3 out = turnedNormal({1.0, 0.0}, polar.phi);
  return FacePoint{out * near.point.x() + Vec3::UnitZ() * near.point.y(),
                   turnedNormal(section_.edge(near.edge).normalAt(near.point), polar.phi)};
}

/// Newton's method on the turn of the sweep that passes nearest.
std::optional<BlankField::FacePoint> TurnedField::threadPoint(std::uint64_t face, const Vec3& p,
                                                              double most) const {
  const auto number = static_cast<int>(face & 0xFFFF) - kThreadFaces;
  const int side = number % kFacesOfThread / 2, parity = number & 1;
  const PolarPoint start = PolarPoint::of(p);
  const HelixSweep* sweep = nullptr;
  double part = 0.0, least = most;
  const Vec2 reach = Vec2::Constant(most);
  threads_.forEachNear(start.inPlane() - reach, start.inPlane() + reach, [&](const HelixSweep& s) {
    if (s.number() % kThreads != number / kFacesOfThread || s.motion() != face >> 16) return;
    HelixSweep::Window window;
    if (!s.window(start.inPlane() - reach, start.inPlane() + reach, window)) return;
    const double beyond = most / (std::max(start.r, most) * std::abs(s.turn()));
    s.forEachPass(start.phi, {window.first - beyond, window.last + beyond}, [&](double t) {
      const double distance = side == HelixSweep::kEndFace
                                  ? std::abs(s.leanAt(side, start, t).value)
                                  : s.outline().nearFace(side, start.inPlane() - s.at(t)).distance;
      // Where the count of the turns goes on, a face has the number of the next one.
      const double seam = std::abs(t * s.turn() / (2.0 * kPi) - std::round(t * s.turn() / (2.0 * kPi)));
      if (s.parityAt(t) != parity && seam > 0.1) return;
      if (distance >= least) return;
      least = distance;
      sweep = &s;
      part = t;
    });
  });
  if (sweep == nullptr) return std::nullopt;
  Vec3 at = p;
  HelixSweep::Lean lean{};
  for (int round = 0; round < 3; ++round) {
    const PolarPoint polar = PolarPoint::of(at);
    lean = sweep->leanAt(side, polar, part + wrapAngle(polar.phi - start.phi) / sweep->turn());
    at -= lean.gradient * (lean.value / lean.gradient.squaredNorm());
    if (std::abs(lean.value) < 1e-9) break;
  }
  return FacePoint{at, -lean.gradient.normalized()};
}

/// No lathe turns so often in one cut; the columns of the grid ask every turn that is near.
constexpr double kMostTurnsOnGrid = 1e5;

Status checkLoop(const SectionLoop& loop) {
  if (loop.points.size() < 3) return inputError("turned part: a loop of its section has less than 3 points");
  if (loop.motion.size() != loop.points.size())
    return inputError("turned part: a loop of its section does not name a motion for each edge");
  for (const Vec2& p : loop.points) {
    if (!p.allFinite() || p.x() < 0.0)
      return inputError(fmt::format("turned part: r {} z {} is no point of a section", p.x(), p.y()));
  }
  return Done{};
}

Status checkThread(const ThreadSweep& s) {
  const bool finite = s.from.allFinite() && s.to.allFinite() && std::isfinite(s.start_rad) &&
                      std::isfinite(s.turns) && std::isfinite(s.bend);
  if (s.outline == nullptr || !finite) return inputError("turned part: a thread without tool or way");
  if (std::abs(s.turns) > kMostTurnsOnGrid)
    return inputError(fmt::format("turned part: a thread of more than {:g} turns", kMostTurnsOnGrid));
  if (s.turns == 0.0) return inputError("turned part: a thread during which the part does not turn");
  if (std::abs(s.bend) > 1.0) return inputError("turned part: a thread whose lead changes its sign");
  return Done{};
}

}  // namespace

Result<std::unique_ptr<BlankField>> makeTurnedField(const std::shared_ptr<const TurnedShape>& shape) {
  if (turnedBounds(shape.get()).empty()) return inputError("turned part: nothing is left of it");
  for (const SectionBody& body : shape->bodies) {
    for (const SectionLoop& loop : body.loops) {
      if (Status status = checkLoop(loop); !status) return status.error();
    }
  }
  for (const ThreadSweep& thread : shape->threads) {
    if (Status status = checkThread(thread); !status) return status.error();
  }
  auto field = std::make_unique<TurnedField>(*shape);
  if (!(field->volume() > 0.0)) return inputError("turned part: its section has no area, or is inside out");
  return std::unique_ptr<BlankField>(std::move(field));
}

Box3 turnedBounds(const TurnedShape* shape) {
  Box3 box;
  if (shape == nullptr) return box;
  for (const SectionBody& body : shape->bodies) {
    for (const SectionLoop& loop : body.loops) {
      for (const Vec2& p : loop.points) {
        box.extend(Vec3(-p.x(), -p.x(), p.y()));
        box.extend(Vec3(p.x(), p.x(), p.y()));
      }
    }
  }
  return box;
}

namespace {

class TurnedBody final : public FieldBody {
 public:
  explicit TurnedBody(std::shared_ptr<const TurnedShape> shape) : shape_(std::move(shape)) {}

  Result<std::unique_ptr<BlankField>> field() const override { return makeTurnedField(shape_); }
  Box3 bounds() const override { return turnedBounds(shape_.get()); }
  double aboutArea() const override {
    const Vec3 size = bounds().size();
    return kPi * size.x() * (0.5 * size.x() + size.z());
  }
  bool volumeIsExact() const override { return shape_->threads.empty(); }

 private:
  std::shared_ptr<const TurnedShape> shape_;
};

}  // namespace

FieldShape turnedStock(std::shared_ptr<const TurnedShape> shape, const RigidTransform& place) {
  return {std::make_shared<const TurnedBody>(std::move(shape)), place};
}

}  // namespace proveout

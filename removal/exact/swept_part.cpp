#include "removal/exact/swept_part.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "core/geometry/box_tree.h"
#include "core/tool/tool_solid.h"
#include "core/tool/tool_type.h"
#include "removal/grid/shape_field.h"
#include "removal/sweep/leaning_sweep.h"
#include "removal/sweep/motion_bodies.h"
#include "removal/turning/section/section.h"
#include "removal/turning/section/section_field.h"
#include "removal/turning/turned_field.h"

namespace proveout {

namespace {

/// Surfaces nearer to each other than this are one, made by the first motion, mm.
constexpr double kSameMm = 1e-8;
/// Boxes of long motions are cut to about this many tool radii, and arcs to an eighth of a turn.
constexpr double kBoxRadii = 6.0;
constexpr double kBoxTurn = kPi / 4.0;
constexpr int kMostBoxes = 4096;

/// One cutting part of a tool on one motion.
struct Body {
  MotionId motion;
  const ConvexProfile* profile;
  std::int32_t curve;  ///< number of the stored sweep, or -1: a line
};

/// The swept volumes of one clamping.
class CutBodies {
  template <typename Ask>
  auto withSweep(const Body& b, const Ask& ask) const {
    if (b.curve >= 0) return ask(curves_[static_cast<std::size_t>(b.curve)]);
    return ask(motionField(*b.profile, wayOf(path_, path_.motions[b.motion])));
  }

 public:
  explicit CutBodies(const ClampedCut& cut) : path_(*cut.path), from_last_(cut.from_last) {
    for (const Tool& tool : *cut.tools) {
      if (rowOf(tool.type).rotates) solids_.try_emplace(tool.number, makeToolSolid(tool));
    }
    for (MotionId id = 0; id < path_.motions.size(); ++id) add(id);
    tree_ = BoxTree(boxes_);
    boxes_ = {};
  }
  CutBodies(const CutBodies&) = delete;

  struct Nearest {
    double distance;  ///< to the swept volume, mm; below 0 inside
    std::int64_t body = -1;
  };
  /// The body whose swept volume is nearest, or covers the point deepest: with a distance below `within`,
  /// which may be below 0. `p`: in the frame of the last clamping.
  Nearest nearest(const Vec3& p, double within) const {
    const Vec3 q = from_last_(p);
    const Vec3 reach = Vec3::Constant(std::max(within, 0.0));
    Nearest best{within, -1};
    tree_.forEachPlace({q - reach, q + reach}, [&](std::uint32_t place) {
      const Boxed& boxed = body_of_[tree_.order()[place]];
      const std::int64_t number = boxed.body;
      if (number == best.body && boxed.stretch == kWhole) return;
      const double d = distance(boxed, q, best.distance + kSameMm);
      const bool same = std::abs(d - best.distance) <= kSameMm && best.body >= 0;
      if (same ? number < best.body : d < best.distance) best = {d, number};
    });
    return best;
  }
  /// Direction in which the point gets out of the body fastest, last clamping's frame.
  Vec3 gradient(std::int64_t body, const Vec3& p) const {
    const Body& b = bodies_[static_cast<std::size_t>(body)];
    return from_last_.rotation.transpose() *
           withSweep(b, [&](const SweptField& s) { return s.sample(from_last_(p)).gradient; });
  }
  MotionId motionOf(std::int64_t body) const { return bodies_[static_cast<std::size_t>(body)].motion; }

 private:
  static constexpr std::uint32_t kWhole = static_cast<std::uint32_t>(-1);
  /// What is in a box: a body or one stretch of it.
  struct Boxed {
    std::uint32_t body, stretch;
  };

  void add(MotionId id) {
    const Motion& m = path_.motions[id];
    const auto solid = solids_.find(m.tool);
    if (m.kind == MotionKind::kProbe || solid == solids_.end()) return;
    for (const ConvexProfile& profile : solid->second.cutter) {
      if (wayOf(path_, m).turns()) {
        addPosed(id, profile);
      } else if (m.arc < 0) {
        addLine(id, profile);
      } else {
        addArc(id, profile, path_.arcs[static_cast<std::size_t>(m.arc)]);
      }
    }
  }

  /// The box of a line along an axis is as good as many.
  void addLine(MotionId id, const ConvexProfile& profile) {
    const Motion& m = path_.motions[id];
    bodies_.push_back({id, &profile, -1});
    Vec3 sides = (m.to - m.from).cwiseAbs();
    std::sort(sides.data(), sides.data() + 3);
    const double unit = kBoxRadii * std::max(profile.maxRadius(), 0.01);
    const int count = std::clamp(static_cast<int>(sides[1] / unit), 1, kMostBoxes);
    for (int i = 0; i < count; ++i)
      addBox(m, profile, static_cast<double>(i) / count, static_cast<double>(i + 1) / count, 0.0);
  }

  /// Circles about the tool's axis have a closed form, however long they are; other curves are taken in
  /// pieces.
  void addArc(MotionId id, const ConvexProfile& profile, const ArcGeometry& arc) {
    const Motion& m = path_.motions[id];
    const ArcFrame frame = arcFrame(m.from, m.to, arc);
    const MotionWay way = wayOf(path_, m);
    const bool circle = arc.normal.cross(way.direction()).isZero(1e-12) && std::abs(frame.rise) < kSameMm &&
                        std::abs(frame.radius_end - frame.radius_start) < kSameMm;
    const int count = static_cast<int>(
        std::clamp(std::ceil(std::abs(arc.sweep_rad) / kBoxTurn), 1.0, static_cast<double>(kMostBoxes)));
    // A chord of a circle stands off it by r (1 - cos(angle / 2)).
    const double slack = std::max(frame.radius_start, frame.radius_end) *
                         (1.0 - std::cos(std::min(kPi, 0.5 * std::abs(arc.sweep_rad) / count)));
    for (int i = 0; i < count; ++i) {
      const double from = static_cast<double>(i) / count, to = static_cast<double>(i + 1) / count;
      if (!circle || i == 0) {
        bodies_.push_back({id, &profile, static_cast<std::int32_t>(curves_.size())});
        const ArcGeometry piece{arc.center + from * frame.rise * frame.n, arc.normal, arc.sweep_rad / count};
        Motion part = m;
        if (!circle) part.from = arcPoint(frame, arc, from), part.to = arcPoint(frame, arc, to);
        curves_.push_back(motionField(profile, {part, circle ? &arc : &piece, way.axis}));
      }
      addBox(m, profile, from, to, slack);
    }
  }

  /// A motion that turns the axis, in boxes of pieces of its stretches.
  void addPosed(MotionId id, const ConvexProfile& profile) {
    bodies_.push_back({id, &profile, static_cast<std::int32_t>(curves_.size())});
    curves_.push_back(motionField(profile, wayOf(path_, path_.motions[id])));
    const std::vector<PosedStretch>& stretches = curves_.back().posed()->stretches();
    const double unit = kBoxRadii * std::max(profile.maxRadius(), 0.01);
    const int most = std::max(1, kMostBoxes / static_cast<int>(stretches.size()));
    for (const PosedStretch& stretch : stretches) {
      const double way = 2.0 * stretch.mostShift(farthestFromTip(profile));
      const int count = static_cast<int>(std::clamp(std::ceil(way / unit), 1.0, static_cast<double>(most)));
      for (int i = 0; i < count; ++i) {
        boxes_.push_back(boundsBetween(profile, stretch, 2.0 * i / count - 1.0, 2.0 * (i + 1) / count - 1.0));
        body_of_.push_back({static_cast<std::uint32_t>(bodies_.size() - 1),
                            static_cast<std::uint32_t>(&stretch - stretches.data())});
      }
    }
  }

  /// Around the way from one parameter of the motion to another, for the last body.
  void addBox(const Motion& m, const ConvexProfile& profile, double from, double to, double slack) {
    const Vec3 a = path_.pointAt(m, from), b = path_.pointAt(m, to);
    boxes_.push_back(partBounds(profile, wayOf(path_, m), {a.cwiseMin(b), a.cwiseMax(b)}, slack));
    body_of_.push_back({static_cast<std::uint32_t>(bodies_.size() - 1), kWhole});
  }

  double distance(const Boxed& boxed, const Vec3& q, double cutoff) const {
    return withSweep(bodies_[boxed.body], [&](const SweptField& s) {
      if (boxed.stretch == kWhole) return s.distance(q, cutoff);
      return s.posed()->nearest(q, {cutoff, kLineToleranceMm}, boxed.stretch, boxed.stretch + 1).value;
    });
  }

  const Toolpath& path_;
  RigidTransform from_last_;
  std::map<int, ToolSolid> solids_;  ///< by number of the tool
  std::vector<Body> bodies_;
  std::deque<SweptField> curves_;
  std::vector<Box3> boxes_;
  std::vector<Boxed> body_of_;  ///< per box
  BoxTree tree_;
};

class SweptPart final : public ExactPart {
 public:
  SweptPart(std::unique_ptr<BlankField> blank, const std::vector<ClampedCut>& cuts, std::uint32_t blank_setup)
      : blank_(std::move(blank)), blank_setup_(blank_setup), to_first_(cuts.front().from_last) {
    for (const ClampedCut& cut : cuts) cuts_.emplace_back(cut);
  }

  Sample at(const Vec3& p, double reach) const override {
    const BlankSample outer = blank_->sample(to_first_(p));
    Sample out{std::clamp(outer.value, -reach, reach), Vec3::UnitZ(), {blank_setup_, outer.motion}};
    // Only what is nearer than the blank's surface, or covers the point deeper than that is off, counts.
    double within = std::min(reach, -outer.value);
    const CutBodies* by = nullptr;
    std::int64_t body = -1;
    for (std::uint32_t k = 0; k < cuts_.size(); ++k) {
      const CutBodies::Nearest found = cuts_[k].nearest(p, within);
      if (found.body < 0) continue;
      within = found.distance;
      by = &cuts_[k];
      body = found.body;
      out.maker = {k, by->motionOf(body)};
    }
    if (by == nullptr) {
      out.normal = to_first_.rotation.transpose() * outer.normal;
      return out;
    }
    out.value = std::clamp(-within, -reach, reach);
    out.normal = -by->gradient(body, p);
    return out;
  }
  double accuracy() const override { return 1e-6; }  // kSweepToleranceMm and rounding

 private:
  std::unique_ptr<BlankField> blank_;
  std::uint32_t blank_setup_;
  RigidTransform to_first_;
  std::deque<CutBodies> cuts_;
};

class TurnedPart final : public ExactPart {
 public:
  TurnedPart(std::unique_ptr<BlankField> field, const TurnedShape& shape)
      : field_(std::move(field)), section_(shape.bodies) {
    for (const ThreadSweep& thread : shape.threads) {
      const double beyond = thread.outline->max().cwiseAbs().maxCoeff();  // of the axis, if it reaches there
      threads_.push_back({{std::min(thread.from.x(), thread.to.x()) + thread.outline->min().x(),
                           std::min(thread.from.y(), thread.to.y()) + thread.outline->min().y()},
                          {std::max(thread.from.x(), thread.to.x()) + thread.outline->max().x(),
                           std::max(thread.from.y(), thread.to.y()) + thread.outline->max().y()},
                          thread.from.x() < beyond || thread.to.x() < beyond});
    }
  }

  Sample at(const Vec3& p, double reach) const override {
    const Vec2 q(p.head<2>().norm(), p.z());
    const SectionField::Nearest near = section_.nearest(q, 1e300);
    if (isThreadNear(q, near.distance)) {
      const BlankSample s = field_->sample(p);
      return {std::clamp(s.value, -reach, reach), s.normal, {SurfaceMaker::kLastSetup, s.motion}};
    }
    const bool inside = section_.inside(q);
    const SectionField::Edge& edge = section_.edge(near.edge);
    // The way to the nearest point: beside corners and on short edges a normal of the face is not.
    Vec2 out = edge.normalAt(near.point);
    if (near.distance > kAway) out = (inside ? 1.0 : -1.0) * (near.point - q) / near.distance;
    const Vec2 around = q.x() > 0.0 ? Vec2(p.head<2>() / q.x()) : Vec2::UnitX();
    return {std::clamp(inside ? -near.distance : near.distance, -reach, reach),
            Vec3(out.x() * around.x(), out.x() * around.y(), out.y()),
            {SurfaceMaker::kLastSetup, edge.motion}};
  }
  double accuracy() const override { return kSectionChordMm; }

 private:
  static constexpr double kAway = 1e-6;  ///< mm: what is nearer is on the surface

  /// Bounds of all that a thread's tool reaches, (r, z).
  struct Reach {
    Vec2 low, high;
    bool over_axis;
  };
  /// Whether a thread may come nearer than the section does.
  bool isThreadNear(const Vec2& q, double distance) const {
    return std::any_of(threads_.begin(), threads_.end(), [&](const Reach& t) {
      return t.over_axis || (t.low - q).cwiseMax(q - t.high).maxCoeff() <= distance;
    });
  }

  std::unique_ptr<BlankField> field_;
  SectionField section_;
  std::vector<Reach> threads_;
};

}  // namespace

Result<std::unique_ptr<ExactPart>> makeSweptPart(const StockShape& blank, const std::vector<ClampedCut>& cuts,
                                                 std::uint32_t blank_setup) {
  Result<std::unique_ptr<BlankField>> field = shapeField(blank);
  if (!field) return field.error();
  if (*field == nullptr) return std::unique_ptr<ExactPart>();
  return std::unique_ptr<ExactPart>(std::make_unique<SweptPart>(std::move(*field), cuts, blank_setup));
}

Result<std::unique_ptr<ExactPart>> makeTurnedPart(const std::shared_ptr<const TurnedShape>& shape) {
  Result<std::unique_ptr<BlankField>> field = makeTurnedField(shape);
  if (!field) return field.error();
  return std::unique_ptr<ExactPart>(std::make_unique<TurnedPart>(std::move(*field), *shape));
}

}  // namespace proveout

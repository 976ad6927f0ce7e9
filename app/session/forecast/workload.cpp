// What a run does, from its path, tools and blank: what of it the forecast counts.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "app/session/forecast/height_map.h"
#include "app/session/forecast/prediction.h"
#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/path/posed_way.h"
#include "core/tool/tool_solid.h"
#include "core/tool/tool_type.h"
#include "removal/sweep/kinds/pose_solid.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {
namespace {

/// Along a line more leaves are asked than over its ends, which the motions beside it have cut.
constexpr double kLineCounts = 2.0;
/// Poses of a tool that turns stand as close as removal has them, 16 to a piece; more pieces are taken as
/// these.
constexpr double kPosesAPiece = 16.0;
constexpr int kMostLooked = 64;
/// Tools whose axis rises by more leave what the height map shows.
constexpr double kSteep = 0.5;
/// Directions that differ by less than about this cut one face.
constexpr double kSameFace = 0.15;
/// The height map has at most this many cells along a side, and its making touches at most so many.
constexpr int kMapSide = 256;
constexpr double kMapWork = 1.5e6;
/// Arcs as this many chords a turn: enough for a coarse map.
constexpr double kChordsPerTurn = 24.0;
constexpr double kChordMm = 5e-5;
/// Times the surface that the height map shows of what undercut tools leave.
constexpr float kUndercutFaces = 2.0F;
/// A line that is so many times longer than its tool is wide leaves strips.
constexpr double kRuledWidths = 2.0;
/// Lines side by side pass over each place so many times, and only the first time most of it is there to be
/// cut: the rest is culled. No more times are counted, as layers under each other have something to cut.
constexpr double kMostCover = 10.0;
/// Of spirals: what a column costs was measured for parts of this size.
constexpr double kPartsPerTurn = 8.0, kSpiralGrowthMm = 1e-4;
/// Arcs that rise by less along their axis, and whose axis is that level, are cut as upright ones.
constexpr double kSameMm = 1e-7, kLevelAxis = 1e-12;
/// Of helices: the lower turns hold what the upper ones cut.
constexpr double kTurnsThatCount = 1.5;

void add(CurveWork& sum, const CurveWork& more) {
  sum.chords += more.chords;
  sum.fresh += more.fresh;
  sum.columns_mm2 += more.columns_mm2;
}

int segmentsOf(const Toolpath& path, const Motion& motion) {
  if (motion.arc < 0) return 1;
  PROVEOUT_ASSERT(static_cast<std::size_t>(motion.arc) < path.arcs.size());
  const double turns = std::abs(path.arcs[static_cast<std::size_t>(motion.arc)].sweep_rad) / (2 * kPi);
  return static_cast<int>(std::clamp(std::ceil(turns * kChordsPerTurn), 1.0, 10000.0));
}

template <typename Use>
void forEachSegment(const Toolpath& path, const Motion& motion, const Use& use) {
  const int chords = segmentsOf(path, motion);
  Vec3 from = motion.from;
  for (int i = 1; i <= chords; ++i) {
    const Vec3 to = i == chords ? motion.to : path.pointAt(motion, static_cast<double>(i) / chords);
    use(from, to);
    from = to;
  }
}

bool reaches(const Box3& blank, const Vec3& a, const Vec3& b, double radius) {
  Box3 box;
  box.extend(a);
  box.extend(b);
  box = box.inflated(radius);
  box.max.z() = std::numeric_limits<double>::infinity();
  box.min.z() += radius;  // the tip is the lowest point
  return box.overlaps(blank);
}

struct CutterSize {
  Footprint footprint;
  bool undercut = false;  ///< wider below than above somewhere
  bool bulges = false;    ///< and that not by a disc alone
  bool flanked = false;   ///< and by flanks
  double length = 0.0;    ///< of what cuts, from the tip, mm
  bool ball = false;      ///< its end goes the same way however the tool leans
  bool known = true;      ///< kernels of tools that lean know it
  bool corners = false;   ///< some of them are round
  double bend = 0.0;      ///< least radius of what goes around its axis, mm: poses stand as close as it asks
  bool plain = false;     ///< kernels have vectors for rising spirals: flat and ball ends, bull noses
};

std::map<int, CutterSize> cutterSizes(const std::vector<Tool>& tools) {
  std::map<int, CutterSize> out;
  for (const Tool& tool : tools) {
    const ToolType type = tool.type;
    CutterSize size;
    size.footprint = footprintOf(tool);
    size.undercut = hasNeck(type);
    size.bulges = size.undercut && type != ToolType::kTSlot;
    size.flanked = size.bulges && type != ToolType::kLollipop;
    size.length = tool.flute_length + tool.diameter;
    size.plain = type == ToolType::kFlat || type == ToolType::kBall || type == ToolType::kBull;
    size.ball = type == ToolType::kBall;
    if (rowOf(type).rotates) {
      const std::vector<ConvexProfile> cutter = makeToolSolid(tool).cutter;
      size.known = size.ball || std::all_of(cutter.begin(), cutter.end(), [](const ConvexProfile& part) {
                     return leastRadius(part) > 0.0;
                   });
      size.corners = std::any_of(cutter.begin(), cutter.end(),
                                 [](const ConvexProfile& part) { return poseSolid(part).corners; });
      size.bend = size.footprint.radius;
      for (const ConvexProfile& part : cutter) {
        if (size.known && !size.ball) size.bend = std::min(size.bend, leastRadius(part));
      }
    }
    out[tool.number] = size;
  }
  return out;
}

/// What of a tool that stands at a pose is below the top of the blank, as a box, mm.
Box3 boxBelow(const ToolPose& pose, const CutterSize& cutter, double top) {
  constexpr double kLevel = 0.05;
  const Vec3& d = pose.axis;
  const double r = cutter.footprint.radius, rise = top - pose.tip.z() + r;
  const double length = d.z() > kLevel ? std::clamp(rise / d.z(), 0.0, cutter.length) : cutter.length;
  const Vec3 across = r * (Vec3::Ones() - d.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  Box3 box;
  for (const Vec3& end : {pose.tip, Vec3(pose.tip + length * d)}) {
    box.extend(Vec3(end - across));
    box.extend(Vec3(end + across));
  }
  return box;
}

/// Sizes of what two boxes have in common: all along zero where it is nothing.
Vec3 commonSize(const Box3& a, const Box3& b) {
  const Vec3 size = a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min);
  return size.minCoeff() > 0.0 ? size : Vec3::Zero();
}

/// Faces that tools cut which lean so far that the height map knows nothing of them, by direction.
class LeanFaces {
 public:
  void add(const Vec3& axis, double mm2, const Vec3& blank) {
    const auto key = [](double c) { return static_cast<int>(std::lround(c / kSameFace)); };
    Face& face = faces_[{key(axis.x()), key(axis.y()), key(axis.z())}];
    face.cut_mm2 += mm2;
    const Vec3 d = axis.cwiseAbs();
    face.most_mm2 =
        d.x() * blank.y() * blank.z() + d.y() * blank.z() * blank.x() + d.z() * blank.x() * blank.y();
  }
  void add(const LeanFaces& more) {
    for (const auto& [key, face] : more.faces_) {
      Face& mine = faces_[key];
      mine.cut_mm2 += face.cut_mm2;
      mine.most_mm2 = std::max(mine.most_mm2, face.most_mm2);
    }
  }
  /// From one direction no more is cut than what of the blank is seen from there.
  double mm2() const {
    return std::accumulate(faces_.begin(), faces_.end(), 0.0, [](double sum, const auto& entry) {
      return sum + std::min(entry.second.cut_mm2, entry.second.most_mm2);
    });
  }

 private:
  struct Face {
    double cut_mm2 = 0.0, most_mm2 = 0.0;
  };
  std::map<std::array<int, 3>, Face> faces_;
};

/// The motions that come to the blank.
class Strokes {
 public:
  Strokes(const Toolpath& path, const std::map<int, CutterSize>& cutters, const Box3& blank)
      : path_(path), blank_(blank), parts_((path.motions.size() + kPart - 1) / kPart) {
    parallelFor(std::size_t{0}, parts_.size(), [&](std::size_t i) { collect(i, cutters); });
  }

  double swept_mm2() const { return sum(&Part::swept_mm2); }
  double leanAsked() const { return sum(&Part::lean_asked); }
  double turnAsked() const { return sum(&Part::turn_asked); }
  double tilted_mm2() const { return sum(&Part::tilted_mm2); }
  double faces_mm2() const {
    LeanFaces all;
    for (const Part& part : parts_) all.add(part.faces);
    return all.mm2();
  }

  std::array<CurveWork, kCurveKinds> curves() const {
    std::array<CurveWork, kCurveKinds> sum;
    for (const Part& part : parts_) {
      for (int kind = 0; kind < kCurveKinds; ++kind) add(sum[kind], part.curves[kind]);
    }
    return sum;
  }

  void lower(HeightMap& map, int band) const {
    for (const Part& part : parts_) {
      for (const Stroke& stroke : part.strokes) {
        if (!map.touches(stroke.x_min, stroke.x_max, band)) continue;
        eachSegment(path_.motions[stroke.motion], stroke.tool.radius, stroke.shift,
                    [&](const Vec3& a, const Vec3& b) { map.lower(a, b, stroke.tool, stroke.made, band); });
      }
    }
  }

 private:
  static constexpr std::size_t kPart = 4096;
  struct Stroke {
    MotionId motion;
    Footprint tool;
    CutBy made;
    Vec3 shift;           ///< from its tip to its lowest point
    double x_min, x_max;  ///< mm; what it reaches over
  };
  struct Part {
    std::vector<Stroke> strokes;
    double swept_mm2 = 0.0, tilted_mm2 = 0.0, lean_asked = 0.0, turn_asked = 0.0;
    std::array<CurveWork, kCurveKinds> curves;
    LeanFaces faces;
  };

  double sum(double Part::*member) const {
    return std::accumulate(parts_.begin(), parts_.end(), 0.0,
                           [&](double sum, const Part& part) { return sum + part.*member; });
  }

  /// The parts of a spiral of which `segments` of forEachSegment come to the blank.
  void addSpiral(const Motion& motion, const CutterSize& cutter, double segments, Part& part) const {
    const double share = segments / segmentsOf(path_, motion);
    const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(motion.arc)];
    const double parts = std::max(1.0, share * std::abs(arc.sweep_rad) / (2 * kPi) * kPartsPerTurn);
    const double reach = cutter.footprint.radius, length = share * path_.length(motion) / parts;
    const double plan =
        std::min(kPi * reach * reach + 2 * reach * length, blank_.size().x() * blank_.size().y());
    const CurveKind kind = motion.from.z() == motion.to.z() ? CurveKind::kLevelSpiral
                           : cutter.plain                   ? CurveKind::kPlainSpiral
                           : cutter.undercut                ? CurveKind::kUndercutSpiral
                                                            : CurveKind::kSpiral;
    add(part.curves[static_cast<std::size_t>(kind)], {parts, parts, parts * plan});
  }

  /// The chords of a curve of which `segments` of forEachSegment come to the blank.
  void addChords(const Motion& motion, const CutterSize& cutter, double segments, Part& part) const {
    const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(motion.arc)];
    const bool about_z = arc.normal.head<2>().squaredNorm() < 1e-24;
    if (segments == 0.0) return;
    const double start = (motion.from - arc.center).head<2>().norm(),
                 end = (motion.to - arc.center).head<2>().norm();
    const bool spiral = about_z && std::abs(end - start) > kSpiralGrowthMm;
    if (spiral) return addSpiral(motion, cutter, segments, part);
    if (about_z && motion.from.z() == motion.to.z()) return;
    const double radius = std::max((motion.from - arc.center).norm(), kChordMm);
    double angle = std::abs(arc.sweep_rad) * segments / segmentsOf(path_, motion);
    if (about_z) angle = std::min(angle, kTurnsThatCount * 2 * kPi);
    const double chords = angle / std::sqrt(8.0 * kChordMm / radius);
    const Vec3 size = blank_.size();
    const double reach = cutter.footprint.radius;
    const double plan = std::min(kPi * reach * reach, size.x() * size.y());
    const bool upright = std::abs(arc.normal.z()) < kLevelAxis &&
                         std::abs((motion.to - motion.from).dot(arc.normal.normalized())) < kSameMm;
    CurveKind kind = upright || cutter.plain ? CurveKind::kArc : CurveKind::kChords;
    if (cutter.flanked) kind = CurveKind::kFlankedArc;
    if (about_z) kind = cutter.bulges ? CurveKind::kUndercutHelix : CurveKind::kHelix;
    add(part.curves[static_cast<std::size_t>(kind)], {chords, chords, chords * plan});
    if (kind == CurveKind::kFlankedArc && !upright)
      add(part.curves[static_cast<std::size_t>(CurveKind::kChords)], {chords, chords, 0.0});
  }

  void addBody(CurveKind kind, double count, double columns_mm2, Part& part) const {
    add(part.curves[static_cast<std::size_t>(kind)], {count, count, columns_mm2});
  }

  /// A tool that leans and stands. True: it comes to the blank.
  bool addLeaning(const Motion& motion, const MotionWay& way, const CutterSize& cutter, Part& part) const {
    const double top = blank_.max.z();
    Box3 box = boxBelow({motion.from, way.direction()}, cutter, top);
    forEachSegment(path_, motion, [&](const Vec3&, const Vec3& to) {
      box.extend(boxBelow({to, way.direction()}, cutter, top));
    });
    const Vec3 common = commonSize(box, blank_);
    if (common.x() == 0.0) return false;
    part.lean_asked += share(common);
    const double shadow = common.x() * common.y();
    if (way.arc == nullptr) {
      const bool kernel = cutter.known && !cutter.corners && std::abs(way.direction().z()) >= kLeastAxisRise;
      addBody(kernel ? CurveKind::kLeansOnLine : CurveKind::kLeanSearched, 1.0, shadow, part);
    } else if (way.arc->normal.cross(way.direction()).norm() < kLevelAxis &&
               std::abs((motion.to - motion.from).dot(way.direction())) < kSameMm) {
      addBody(cutter.corners ? CurveKind::kLeanCornerArc : CurveKind::kLeansOnArc, 1.0, shadow, part);
    } else {
      const double radius = std::max((motion.from - way.arc->center).norm(), kChordMm),
                   chords = std::abs(way.arc->sweep_rad) / std::sqrt(8.0 * kChordMm / radius);
      const Vec3 one = commonSize(boxBelow({motion.from, way.direction()}, cutter, top), blank_);
      addBody(CurveKind::kLeanChords, chords, chords * one.x() * one.y(), part);
    }
    return true;
  }

  /// A tool that turns on its way. True: it comes to the blank.
  bool addTurning(const Motion& motion, const CutterSize& cutter, Part& part) const {
    const PosedWay way = posedWayOf(path_, motion);
    const double radius = std::max(cutter.bend, 0.01);
    double speed = 0.0;  // of the tool's farthest point, by the share of the motion
    constexpr int kPlaces = 4;
    for (int i = 0; i < kPlaces; ++i) {
      const PosedWay::Rates rates = way.movingAt((i + 0.5) / kPlaces).rates;
      speed += (rates.tip.norm() + cutter.length * rates.axis.norm()) / kPlaces;
    }
    const double poses = std::max(1.0, speed / std::sqrt(8.0 * kPosesMm * radius));
    const double pieces = std::ceil(poses / kPosesAPiece);
    const int looked = static_cast<int>(std::min(pieces, static_cast<double>(kMostLooked)));
    double near = 0.0, shadow = 0.0, asked = 0.0;
    for (int i = 0; i < looked; ++i) {
      Box3 box = boxBelow(way.at(static_cast<double>(i) / looked), cutter, blank_.max.z());
      box.extend(boxBelow(way.at(static_cast<double>(i + 1) / looked), cutter, blank_.max.z()));
      const Vec3 common = commonSize(box, blank_);
      if (common.x() == 0.0) continue;
      near += 1.0 / looked;
      shadow += common.x() * common.y() * pieces / looked;
      asked += share(common);
    }
    if (near == 0.0) return false;
    part.turn_asked += asked;
    if (cutter.known) {
      addBody(CurveKind::kTurns, near, shadow, part);
      addBody(cutter.ball ? CurveKind::kPoses : CurveKind::kEdgedPoses, near * poses, shadow * poses / pieces,
              part);
    } else {
      addBody(CurveKind::kTurnsSearched, near, shadow, part);
    }
    return true;
  }

  /// Of the blank's box.
  double share(const Vec3& size) const { return size.prod() / blank_.size().cwiseMax(1e-9).prod(); }

  /// A tool that leans or turns: what it takes, and the face that it leaves where the height map shows none.
  /// `direction`: in the middle of its way.
  void addTilted(const Motion& motion, const MotionWay& way, const CutterSize& cutter, const Vec3& direction,
                 Part& part) const {
    const bool comes = way.turns() ? addTurning(motion, cutter, part) : addLeaning(motion, way, cutter, part);
    if (!comes) return;
    const double length = std::min(path_.length(motion), blank_.size().sum()),
                 mm2 = 2.0 * cutter.footprint.radius * length;
    part.tilted_mm2 += mm2;
    if (!isSteep(direction)) part.faces.add(direction, mm2, blank_.size());
  }
  static bool isSteep(const Vec3& direction) { return direction.z() > kSteep; }

  /// What a motion leaves, of which chords of this length come to the blank.
  CutBy cutBy(const Motion& motion, const CutterSize& cutter) const {
    const Footprint& tool = cutter.footprint;
    const bool ruled =
        motion.arc < 0 && (motion.to - motion.from).head<2>().norm() > 2.0 * kRuledWidths * tool.radius;
    const bool sharp = tool.flat_radius == tool.radius && !cutter.undercut;
    const bool plane = ruled && sharp;
    const bool stepped = sharp && !ruled && motion.arc < 0 && motion.from.z() != motion.to.z() &&
                         motion.from.head<2>() != motion.to.head<2>();
    return {plane || !(tool.radius > 0.0) ? 0.0F : static_cast<float>(1.0 / tool.radius),
            cutter.bulges ? kUndercutFaces : 1.0F, ruled, stepped};
  }

  template <typename Use>
  void eachSegment(const Motion& motion, double radius, const Vec3& shift, const Use& use) const {
    forEachSegment(path_, motion, [&](const Vec3& from, const Vec3& to) {
      const Vec3 a = from + shift, b = to + shift;
      if (reaches(blank_, a, b, radius)) use(a, b);
    });
  }

  void collect(std::size_t number, const std::map<int, CutterSize>& cutters) {
    Part& part = parts_[number];
    const double most_x = blank_.size().x(), most_y = blank_.size().y();
    const std::size_t last = std::min(path_.motions.size(), (number + 1) * kPart);
    for (std::size_t i = number * kPart; i < last; ++i) {
      const Motion& motion = path_.motions[i];
      const auto found = cutters.find(motion.tool);
      const CutterSize cutter = found == cutters.end() ? CutterSize{} : found->second;
      const MotionWay way = wayOf(path_, motion);
      const bool tilted = way.leans() || way.turns();
      Vec3 shift = Vec3::Zero();
      if (tilted) {
        const Vec3 direction = way.turns() ? posedWayOf(path_, motion).at(0.5).axis : way.direction();
        addTilted(motion, way, cutter, direction, part);
        if (!isSteep(direction)) continue;
        // The lowest point of a ball is not its tip.
        if (cutter.ball) shift = cutter.footprint.radius * (direction - Vec3::UnitZ());
      }
      const double radius = cutter.footprint.radius;
      double segments = 0.0, length_mm = 0.0;
      constexpr double kNowhere = std::numeric_limits<double>::infinity();
      Stroke stroke{
          static_cast<MotionId>(i), cutter.footprint, cutBy(motion, cutter), shift, kNowhere, -kNowhere};
      eachSegment(motion, radius, shift, [&](const Vec3& a, const Vec3& b) {
        ++segments;
        length_mm += std::min((b - a).norm(), most_x + most_y);
        stroke.x_min = std::min(stroke.x_min, std::min(a.x(), b.x()) - radius);
        stroke.x_max = std::max(stroke.x_max, std::max(a.x(), b.x()) + radius);
      });
      if (stroke.x_min <= stroke.x_max) part.strokes.push_back(stroke);
      if (tilted) continue;
      // A line is one pass, a curve one a turn.
      const double passes = motion.arc < 0 ? std::min(segments, 1.0) : segments / kChordsPerTurn;
      part.swept_mm2 += ((motion.arc < 0 ? kLineCounts : 1.0) * length_mm + passes * 2 * radius) *
                        std::min(2 * radius, std::max(most_x, most_y));
      if (motion.arc >= 0) addChords(motion, cutter, segments, part);
    }
  }

  const Toolpath& path_;
  const Box3& blank_;
  std::vector<Part> parts_;
};

}  // namespace

double thinLength(const TriMesh& mesh) {
  constexpr double kThin = 16.0;  // longest side, squared, over the area
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Vec3 a = mesh.positions[triangle[0]].cast<double>(), b = mesh.positions[triangle[1]].cast<double>(),
               c = mesh.positions[triangle[2]].cast<double>();
    const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}),
                 area = 0.5 * (b - a).cross(c - a).norm();
    if (longest2 > kThin * area) sum += std::sqrt(longest2);
  }
  return sum;
}

double blankArea(const StockShape& shape, const Box3& bounds) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return meshArea(mesh->mesh);
  if (const auto* round = std::get_if<CylinderShape>(&shape)) {
    const double r = round->radius, inner = round->inner_radius;
    return 2 * kPi * ((r + inner) * round->length + r * r - inner * inner);
  }
  const Vec3 s = bounds.size();
  if (const auto* known = std::get_if<FieldShape>(&shape)) return known->body->aboutArea();
  return 2 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
}

/// Of bodies of tools that lean or turn: how many find something to cut, and of what they cover as much.
/// Circles are cut in pockets, where each cuts anew.
static void keepFresh(std::array<CurveWork, kCurveKinds>& curves, double tilted_mm2, double cut_mm2) {
  const double cover = std::clamp(tilted_mm2 / std::max(cut_mm2, 1e-9), 1.0, kMostCover);
  for (int kind = kFirstTilted; kind < kCurveKinds; ++kind) {
    if (kind == static_cast<int>(CurveKind::kLeansOnArc) ||
        kind == static_cast<int>(CurveKind::kLeanCornerArc))
      continue;
    curves[kind].fresh /= cover;
    curves[kind].columns_mm2 /= cover;
  }
}

Workload workloadOf(const Toolpath& path, const std::vector<Tool>& tools, const Box3& blank,
                    double blank_mm2) {
  const Strokes strokes(path, cutterSizes(tools), blank);
  Workload work;
  work.clampings = 1;
  work.motions = path.motions.size();
  work.swept_mm2 = strokes.swept_mm2();
  work.curves = strokes.curves();
  work.lean_asked = strokes.leanAsked();
  work.turn_asked = strokes.turnAsked();
  double cell = std::max(blank.size().x(), blank.size().y()) / kMapSide;
  cell = std::max(cell, std::sqrt(work.swept_mm2 / kMapWork));
  HeightMap map(blank, cell);
  parallelFor(0, HeightMap::kBands, [&](int band) { strokes.lower(map, band); });
  work.surface_mm2 = std::max(blank_mm2 + map.addedArea(), 0.1 * blank_mm2);
  const CutAreas cut = map.cutAreas();
  const double faces = std::min(strokes.faces_mm2(), std::max(0.0, work.surface_mm2 - cut.all_mm2));
  work.cut_mm2 = std::min(cut.all_mm2 + faces, work.surface_mm2);
  work.flat_mm2 = cut.flat_mm2 + faces;
  work.ruled_mm2 = cut.ruled_mm2;
  work.stepped_mm2 = cut.stepped_mm2;
  work.bends_mm = cut.bends_mm;
  work.uneven_mm2 = std::min(map.unevenArea(), work.surface_mm2);
  keepFresh(work.curves, strokes.tilted_mm2(), work.cut_mm2);
  return work;
}

Workload together(const Workload& a, const Workload& b) {
  Workload both = a;
  for (double Workload::*member :
       {&Workload::surface_mm2, &Workload::cut_mm2, &Workload::flat_mm2, &Workload::ruled_mm2,
        &Workload::stepped_mm2, &Workload::bends_mm, &Workload::uneven_mm2, &Workload::unmerged_mm2,
        &Workload::nominal_mm2, &Workload::fixture_mm2, &Workload::fixture_mesh_mm2, &Workload::pixels,
        &Workload::triangles, &Workload::thread_triangles, &Workload::groove_triangles, &Workload::turned_mm2,
        &Workload::threaded_mm2, &Workload::blank_triangles, &Workload::blank_thin_mm})
    both.*member = std::max(a.*member, b.*member);
  both.swept_mm2 += b.swept_mm2;
  for (int kind = 0; kind < kCurveKinds; ++kind) add(both.curves[kind], b.curves[kind]);
  both.lean_asked += b.lean_asked;
  both.turn_asked += b.turn_asked;
  both.pictures = std::max(a.pictures, b.pictures);
  both.motions += b.motions;
  both.turned_motions += b.turned_motions;
  both.pass_points += b.pass_points;
  both.reads_grid |= b.reads_grid;
  both.writes_grid |= b.writes_grid;
  both.text_files = std::max(a.text_files, b.text_files);
  both.clampings += b.clampings;
  both.mesh_moves += b.mesh_moves;
  return both;
}

}  // namespace proveout

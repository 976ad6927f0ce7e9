#include "app/session/causes/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

#include "app/session/causes/cause_candidates.h"
#include "app/session/causes/wire_offset.h"
#include "app/session/findings/blame.h"
#include "app/session/findings/nose_data.h"
#include "app/session/findings/provenance.h"
#include "app/session/run/process.h"
#include "core/base/parallel_for.h"
#include "core/tool/tool_table.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {
namespace {

/// Points of the surface that are looked at: those beyond a tolerance, and others.
constexpr std::size_t kMostPoints = 8'000;
/// A normal with less of a direction says nothing about a shift along it.
constexpr double kLeastShare = 0.3;
/// A deviation is that of a shift within this share of it; much smaller, it speaks against the shift.
constexpr double kAgrees = 0.4, kContradicts = 0.25;
/// What a wrong nose radius could be is worth so much of what a shift is.
constexpr double kLooseWorth = 0.6;
constexpr std::size_t kMostCauses = 6, kMostBlocks = 12;
constexpr double kLeastBlock = 0.005;  // of the area
/// Candidates that explain less are not told.
constexpr double kLeastScore = 0.15, kOfBest = 0.3;

/// A point of the machined surface, in the frame of the clamping whose motion left it.
struct Point {
  Vec3 p = Vec3::Zero(), normal = Vec3::UnitZ();
  Vec3 last = Vec3::Zero();  ///< in the last clamping's frame
  double deviation = 0.0, area = 0.0;
  std::uint32_t setup = 0;
  MotionId motion = kNoMotion;
  bool off = false;  ///< beyond its tolerance
};

/// Where a candidate moves what a motion cut: the whole way, more and more towards its end, or less and less,
/// as the word behind the motion's start does.
enum class Reach : std::uint8_t { kWhole, kGrowing, kFading };
struct Effect {
  std::uint32_t hypothesis;
  Reach reach;
};

struct Hypothesis {
  CauseCandidate candidate;
  std::uint32_t setup = 0;
  double off_mm = 0.0;
  double explained = 0.0, contradicted = 0.0;     ///< area, mm2
  std::vector<std::pair<double, double>> offers;  ///< shift, weight: of points beyond a tolerance
};

class Diagnosis {
 public:
  Diagnosis(const RunSources& sources, const ExactPart* part, const std::vector<PatchFinding>& patches,
            RunResult& run)
      : sources_(sources), part_(part), run_(run) {
    gatherPoints(patches);
    findHypotheses();
    measureShifts();
    weigh();
  }

  void tell(const PatchFinding& patch) const {
    Finding& finding = run_.findings[patch.finding];
    tellBlocks(*patch.patch, finding);
    tellNose(*patch.patch, finding);
    tellNoOffset(*patch.patch, finding);
    const std::vector<double> local = localShares(*patch.patch);
    std::vector<std::pair<double, std::uint32_t>> ranked;
    for (std::uint32_t h = 0; h < hypotheses_.size(); ++h) {
      if (local[h] > 0.0) ranked.emplace_back(local[h] * worth(hypotheses_[h]), h);
    }
    const auto rank = [&](std::uint32_t h) { return hypotheses_[h].candidate.rank; };
    std::stable_sort(ranked.begin(), ranked.end(), [&](const auto& a, const auto& b) {
      // What explains about as much is told in order of likelihood.
      const int x = static_cast<int>(20.0 * a.first), y = static_cast<int>(20.0 * b.first);
      return x != y ? x > y : rank(a.second) < rank(b.second);
    });
    for (const auto& [score, h] : ranked) {
      if (score < kLeastScore || score < kOfBest * ranked.front().first ||
          finding.causes.size() >= kMostCauses)
        break;
      finding.causes.push_back(causeOf(hypotheses_[h], local[h]));
    }
    // What explains less than half of it is not the whole story.
    constexpr double kEnough = 0.5;
    const bool enough = std::any_of(finding.causes.begin(), finding.causes.end(),
                                    [](const Cause& c) { return c.explains >= kEnough; });
    if (enough) return;
    if (finding.causes.empty() && patch.patch->kind == DeviationKind::kExcess)
      tellUncut(*patch.patch, finding);
    tellInForce(*patch.patch, finding);
  }

 private:
  CauseSource sourceOf(std::uint32_t setup) const {
    const SetupRun& s = run_.setups[setup];
    const RecordingSource* texts = sources_[setup];
    const Toolpath& path = s.interpreted.path;
    return {path, s.job.tools, partTurns(s), s.job.control,
            [texts, &path](std::uint32_t file, std::uint32_t line) {
              return file < path.files.size() ? texts->line(path.files[file], line) : std::string();
            }};
  }

  std::uint32_t setupOf(const SurfaceMaker& maker) const {
    return std::min(maker.setup, static_cast<std::uint32_t>(run_.setups.size() - 1));
  }

  /// From the last clamping's frame into that of another.
  RigidTransform into(std::uint32_t setup) const {
    RigidTransform out;
    for (std::size_t k = run_.setups.size() - 1; k > setup; --k)
      out = run_.setups[k].from_previous.inverse() * out;
    return out;
  }

  bool beyond(double deviation) const {
    return deviation > run_.comparison->excess_tolerance_mm ||
           -deviation > run_.comparison->gouge_tolerance_mm;
  }

  void gatherPoints(const std::vector<PatchFinding>& patches) {
    const std::size_t count = run_.surface().mesh.triangles.size();
    std::vector<std::uint32_t> off, other;
    for (std::uint32_t t = 0; t < count; ++t) (mayBeOff(triangleOf(t), patches) ? off : other).push_back(t);
    for (const auto* side : {&off, &other}) {
      const std::size_t stride = side->size() / kMostPoints + 1;
      for (std::size_t i = 0; i < side->size(); i += stride)
        addPoints((*side)[i], static_cast<double>(stride));
    }
    parallelFor(std::size_t{0}, points_.size(), [&](std::size_t i) { measure(points_[i]); });
    std::erase_if(points_, [](const Point& p) { return std::isnan(p.deviation); });
  }

  struct Triangle {
    std::array<Vec3, 3> at;
    std::array<double, 3> deviation;  ///< of the corners
    double longest = 0.0;             ///< edge
  };

  Triangle triangleOf(std::uint32_t t) const {
    const TriMesh& mesh = run_.surface().mesh;
    Triangle out;
    for (std::size_t c = 0; c < 3; ++c) {
      out.at[c] = mesh.positions[mesh.triangles[t][c]].cast<double>();
      out.deviation[c] = static_cast<double>(run_.comparison->vertex_deviation[mesh.triangles[t][c]]);
    }
    for (std::size_t c = 0; c < 3; ++c)
      out.longest = std::max(out.longest, (out.at[(c + 1) % 3] - out.at[c]).norm());
    return out;
  }

  /// Corners of long triangles tell nothing of what is between them: they may lie on faces beside that are
  /// right.
  bool isLong(const Triangle& t) const { return t.longest > 2.0 * run_.resolution_mm; }

  bool mayBeOff(const Triangle& t, const std::vector<PatchFinding>& patches) const {
    if (std::any_of(t.deviation.begin(), t.deviation.end(), [&](double d) { return beyond(d); })) return true;
    if (!isLong(t)) return false;
    Box3 box;
    for (const Vec3& p : t.at) box.extend(p);
    return std::any_of(patches.begin(), patches.end(),
                       [&](const PatchFinding& p) { return p.patch->bounds.overlaps(box); });
  }

  /// Several to a large triangle.
  void addPoints(std::uint32_t number, double weight) {
    const Triangle t = triangleOf(number);
    const Vec3 a = t.at[0], b = t.at[1], c = t.at[2], n = 0.5 * (b - a).cross(c - a);
    const double area = n.norm(), cell = 4.0 * run_.resolution_mm * run_.resolution_mm;
    if (!(area > 0.0)) return;
    constexpr int kMostSplits = 8;
    const int splits = std::clamp(static_cast<int>(std::sqrt(area / cell)), 1, kMostSplits);
    // Where all corners of a small one are well within tolerance their mean does.
    const bool within = !isLong(t) && std::all_of(t.deviation.begin(), t.deviation.end(),
                                                  [&](double d) { return std::abs(d) < least(); });
    const std::vector<MotionId>& motion = run_.surface().mesh.motion;
    Point p;
    p.deviation = within ? (t.deviation[0] + t.deviation[1] + t.deviation[2]) / 3.0
                         : std::numeric_limits<double>::infinity();
    p.motion = number < motion.size() ? motion[number] : kNoMotion;
    p.normal = n / area;
    p.area = weight * area / (0.5 * splits * (splits + 1));
    for (int i = 0; i < splits; ++i) {
      for (int j = 0; j < splits - i; ++j) {
        const double u = (i + 1.0 / 3.0) / splits, w = (j + 1.0 / 3.0) / splits;
        p.last = a + u * (b - a) + w * (c - a);
        points_.push_back(p);
      }
    }
  }

  void measure(Point& p) const {
    if (std::isinf(p.deviation)) p.deviation = static_cast<double>(run_.comparison->field->at(p.last));
    SurfaceMaker maker{SurfaceMaker::kLastSetup, p.motion};
    if (part_ != nullptr) {
      const SettledPoint at = settle(*part_, p.last, 2.0 * run_.resolution_mm);
      maker = at.found ? at.maker : SurfaceMaker{};
    }
    p.setup = setupOf(maker);
    p.motion = maker.motion;
    p.off = beyond(p.deviation);
    const RigidTransform to = into(p.setup);
    p.p = to(p.last);
    p.normal = to.rotation * p.normal;
  }

  void findHypotheses() {
    std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> known;
    for (const Point& p : points_) {
      if (p.motion == kNoMotion) continue;
      const std::uint64_t id = std::uint64_t{p.setup} << 32 | p.motion;
      if (effects_.contains(id)) continue;
      std::vector<Effect>& effects = effects_[id];
      const CauseSource source = sourceOf(p.setup);
      std::vector<CauseCandidate> before =
          p.motion > 0 ? candidatesOf(source, p.motion - 1) : std::vector<CauseCandidate>();
      std::vector<CauseCandidate> own = candidatesOf(source, p.motion);
      const auto has = [](const std::vector<CauseCandidate>& all, const CauseCandidate& c) {
        return std::any_of(all.begin(), all.end(), [&](const CauseCandidate& o) { return o.key == c.key; });
      };
      const auto add = [&](CauseCandidate& c, Reach reach) {
        const auto [at, added] =
            known.try_emplace({p.setup, c.key}, static_cast<std::uint32_t>(hypotheses_.size()));
        if (added) hypotheses_.push_back({c, p.setup, 0.0, 0.0, 0.0, {}});
        effects.push_back({at->second, reach});
      };
      for (CauseCandidate& c : own) add(c, has(before, c) ? Reach::kWhole : Reach::kGrowing);
      for (CauseCandidate& c : before) {
        if (c.word && isCoordinate(c.word->kind) && c.shift != CutShift::kRadial && !has(own, c))
          add(c, Reach::kFading);
      }
    }
  }

  /// By how much of a shift the surface there moves along its normal. Where a shift grows along the motion it
  /// is that of a place as far on as the tool is wide.
  struct Lever {
    double low, middle, high;
    bool agrees(double deviation, double shift, double least) const {
      const double a = shift * low, b = shift * high;
      const double near = std::min(std::abs(a), std::abs(b)), far = std::max(std::abs(a), std::abs(b));
      const double size = deviation * (a + b) > 0.0 ? std::abs(deviation) : 0.0;
      return size > 0.0 && size >= std::min((1.0 - kAgrees) * near, near - least) &&
             size <= std::max((1.0 + kAgrees) * far, far + least);
    }
  };

  Lever lever(const Point& p, CutShift shift, Reach reach) const {
    const SetupRun& setup = run_.setups[p.setup];
    const Vec3& n = p.normal;
    double part = 0.0;
    if (partTurns(setup)) {
      part = shift == CutShift::kX        ? outwardOf(p)
             : shift == CutShift::kZ      ? n.z()
             : shift == CutShift::kRadial ? 1.0
                                          : 0.0;
    } else {
      part = shift == CutShift::kX   ? n.x()
             : shift == CutShift::kY ? n.y()
             : shift == CutShift::kZ ? n.z()
                                     : n.head<2>().norm();
    }
    const bool moves = shift == CutShift::kX || shift == CutShift::kY || shift == CutShift::kZ;
    if (reach == Reach::kWhole || !moves) return {part, part, part};
    const auto [t, width] = wayTo(p);
    if (reach == Reach::kFading)
      return {part * std::max(0.0, 1.0 - t - width), part * (1.0 - t), part * std::min(1.0, 1.0 - t + width)};
    return {part * std::max(0.0, t - width), part * t, part * std::min(1.0, t + width)};
  }

  /// How far along its motion a point was cut, 0..1, and the tool's radius on that scale.
  std::pair<double, double> wayTo(const Point& p) const {
    const SetupRun& setup = run_.setups[p.setup];
    const Motion& m = setup.interpreted.path.motions[p.motion];
    const Vec3 way = m.to - m.from;
    const double length = way.norm();
    if (m.arc >= 0 || !(length > 0.0)) return {1.0, m.arc >= 0 ? 1.0 : 0.0};
    const Tool* tool = ToolTable(setup.job.tools).find(m.tool);
    const double radius = tool == nullptr ? 0.0
                          : tool->insert  ? tool->insert->nose_radius
                                          : 0.5 * tool->diameter;
    if (!partTurns(setup) && tool != nullptr && !wayOf(setup.interpreted.path, m).leans()) {
      if (const std::optional<Vec3> tip = tipAt(p, m, *tool)) return {placeOn(m, *tip), 0.0};
    }
    const Vec3 at = partTurns(setup) ? controlAt(p, tool) : p.p;
    return {std::clamp((at - m.from).dot(way) / (length * length), 0.0, 1.0), radius / length};
  }

  /// The share of its way at which the tip was nearest to a place, in plan view but for plunges.
  static double placeOn(const Motion& m, const Vec3& tip) {
    constexpr double kSteep = 0.1;
    const Vec3 way = m.to - m.from;
    const Vec2 plan = way.head<2>();
    const bool plunges = plan.norm() < kSteep * way.norm();
    const double t = plunges ? (tip - m.from).dot(way) / way.squaredNorm()
                             : (tip - m.from).head<2>().dot(plan) / plan.squaredNorm();
    return std::clamp(t, 0.0, 1.0);
  }

  /// Where the tip of a flat, ball or bull nose mill stood when it left the surface at a point; none where
  /// that is open: under a flat face that moves level, and for other tools.
  static std::optional<Vec3> tipAt(const Point& p, const Motion& m, const Tool& tool) {
    constexpr double kLevel = 2e-3, kSameHeight = 1e-6;  // of a normal; mm
    const double radius = 0.5 * tool.diameter;
    double corner = 0.0;
    if (tool.type == ToolType::kBall) {
      corner = radius;
    } else if (tool.type == ToolType::kBull) {
      corner = tool.corner_radius;
    } else if (tool.type != ToolType::kFlat) {
      return std::nullopt;
    }
    const Vec2 side = p.normal.head<2>();
    const double level = side.norm();
    if (level > kLevel || corner >= radius) {
      const double out = corner + (level > kLevel ? (radius - corner) / level : 0.0);
      return Vec3(p.p.x() + out * side.x(), p.p.y() + out * side.y(),
                  p.p.z() - corner * (1.0 - p.normal.z()));
    }
    // Level floors behind a slanted way are where the tool stood: at an end of it.
    if (std::abs(m.to.z() - m.from.z()) < kSameHeight) return std::nullopt;
    return std::abs(p.p.z() - m.to.z()) < std::abs(p.p.z() - m.from.z()) ? m.to : m.from;
  }

  /// Where a turning tool's control point stood when its nose touched the point: all of the part's angles
  /// come to the tool's plane.
  static Vec3 controlAt(const Point& p, const Tool* tool) {
    const Vec2 in_plane(p.p.head<2>().norm(), p.p.z());
    Vec2 control = in_plane;
    if (tool != nullptr && tool->insert)
      control += tool->insert->nose_radius * Vec2(outwardOf(p), p.normal.z()) - noseCenter(*tool->insert);
    return {control.x(), 0.0, control.y()};
  }

  /// Of the normal, the share away from the axis of turning.
  static double outwardOf(const Point& p) {
    const double radius = p.p.head<2>().norm();
    return radius > 0.0 ? p.normal.head<2>().dot(p.p.head<2>()) / radius : 0.0;
  }

  template <typename Body>
  void forEachEffectOn(const Point& p, const Body& body) const {
    const auto found = effects_.find(std::uint64_t{p.setup} << 32 | p.motion);
    if (p.motion == kNoMotion || found == effects_.end()) return;
    for (const Effect& e : found->second)
      body(e.hypothesis, lever(p, hypotheses_[e.hypothesis].candidate.shift, e.reach));
  }

  void measureShifts() {
    for (const Point& p : points_) {
      if (!p.off) continue;
      forEachEffectOn(p, [&](std::uint32_t h, const Lever& lever) {
        const double size = std::abs(lever.middle);
        if (size > kLeastShare)
          hypotheses_[h].offers.emplace_back(p.deviation / lever.middle, weightOf(p) * size);
      });
    }
    for (Hypothesis& h : hypotheses_) h.off_mm = weightedMedian(h.offers);
  }

  static double weightedMedian(std::vector<std::pair<double, double>>& values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    double sum = 0.0;
    for (const auto& v : values) sum += v.second;
    double until = 0.0;
    for (const auto& v : values) {
      until += v.second;
      if (until >= 0.5 * sum) return v.first;
    }
    return values.back().first;
  }

  /// Deep deviations tell more than shallow ones of a large area.
  static double weightOf(const Point& p) { return p.area * std::abs(p.deviation); }

  /// A wrong nose radius shows in corners and on slopes only, more or less of it.
  bool loose(std::uint32_t h) const {
    const Hypothesis& hypothesis = hypotheses_[h];
    return hypothesis.candidate.shift == CutShift::kRadial && partTurns(run_.setups[hypothesis.setup]);
  }

  bool agrees(const Lever& lever, const Point& p, std::uint32_t h) const {
    if (loose(h)) return p.deviation * hypotheses_[h].off_mm > 0.0;
    return lever.agrees(p.deviation, hypotheses_[h].off_mm, least());
  }

  double least() const {
    return 0.5 * std::min(run_.comparison->gouge_tolerance_mm, run_.comparison->excess_tolerance_mm);
  }

  void weigh() {
    for (const Point& p : points_) off_weight_ += p.off ? weightOf(p) : 0.0;
    for (const Point& p : points_) {
      forEachEffectOn(p, [&](std::uint32_t h, const Lever& lever) {
        const double shift = hypotheses_[h].off_mm, expected = std::abs(lever.low) < std::abs(lever.high)
                                                                   ? shift * lever.low
                                                                   : shift * lever.high;
        if (p.off) {
          if (agrees(lever, p, h)) hypotheses_[h].explained += weightOf(p) * (loose(h) ? kLooseWorth : 1.0);
        } else if (!loose(h) && beyond(0.5 * expected) &&
                   std::abs(p.deviation) < kContradicts * std::abs(expected)) {
          hypotheses_[h].contradicted += p.area * std::abs(expected);
        }
      });
    }
  }

  /// What explains much of the part's deviations and contradicts nothing, 0..1.
  double worth(const Hypothesis& h) const {
    const double sum = h.explained + h.contradicted;
    return sum > 0.0 ? h.explained / sum * (0.7 + 0.3 * h.explained / off_weight_) : 0.0;
  }

  bool isOf(const Point& p, const DeviationPatch& patch) const {
    return p.off && (p.deviation > 0.0) == (patch.kind == DeviationKind::kExcess) &&
           patch.bounds.inflated(1.5 * run_.resolution_mm).overlaps({p.last, p.last});
  }

  /// Per hypothesis: the share of a patch that it explains.
  std::vector<double> localShares(const DeviationPatch& patch) const {
    std::vector<double> out(hypotheses_.size(), 0.0);
    double sum = 0.0;
    for (const Point& p : points_) {
      if (!isOf(p, patch)) continue;
      sum += weightOf(p);
      forEachEffectOn(p, [&](std::uint32_t h, const Lever& lever) {
        if (agrees(lever, p, h)) out[h] += weightOf(p) * (loose(h) ? kLooseWorth : 1.0);
      });
    }
    for (double& share : out) share = sum > 0.0 ? share / sum : 0.0;
    return out;
  }

  Cause causeOf(const Hypothesis& h, double share) const {
    Cause cause = causeOf(h.candidate, h.setup);
    const CutShift shift = h.candidate.shift;
    cause.along = shift == CutShift::kX   ? "X"
                  : shift == CutShift::kY ? "Y"
                  : shift == CutShift::kZ ? "Z"
                                          : "radius";
    cause.off_mm = h.off_mm;
    cause.explains = std::min(share, 1.0);
    return cause;
  }

 public:
  Cause causeOf(const CauseCandidate& candidate, std::uint32_t setup) const {
    return makeCause(candidate, run_.setups[setup].interpreted.path, *sources_[setup]);
  }

  static Cause makeCause(const CauseCandidate& candidate, const Toolpath& path,
                         const RecordingSource& texts) {
    Cause cause;
    if (!candidate.word) {
      cause.what = candidate.datum;
      cause.value = candidate.value;
      return cause;
    }
    const ResolvedOrigin& word = *candidate.word;
    const auto place = [&](const ResolvedOrigin& w) { return blockRef(path, w, texts); };
    cause.what = originKindName(word.kind);
    cause.value = word.text;
    cause.source = place(word);
    cause.column = word.begin;
    cause.incremental = word.incremental;
    for (const ResolvedOrigin& from : word.from) cause.from.push_back(place(from));
    return cause;
  }

 private:
  void tellBlocks(const DeviationPatch& patch, Finding& finding) const {
    for (const MakerShare& m : patch.makers) {
      if (m.maker.motion == kNoMotion || m.share < kLeastBlock || finding.blocks.size() >= kMostBlocks)
        continue;
      const std::uint32_t setup = setupOf(m.maker);
      const SetupRun& s = run_.setups[setup];
      const Toolpath& path = s.interpreted.path;
      if (m.maker.motion >= path.motions.size()) continue;
      const Motion& motion = path.motions[m.maker.motion];
      BlockRef block = writtenBlock(path, m.maker.motion, *sources_[setup]).block;
      const auto same = std::find_if(finding.blocks.begin(), finding.blocks.end(), [&](const BlockShare& b) {
        return b.setup == s.name && b.block.file == block.file && b.block.line == block.line &&
               b.block.depth == block.depth;
      });
      if (same != finding.blocks.end()) {
        same->share += m.share;
      } else {
        finding.blocks.push_back({std::move(block), s.name, motion.tool, m.share});
      }
    }
    std::stable_sort(finding.blocks.begin(), finding.blocks.end(),
                     [](const BlockShare& a, const BlockShare& b) { return a.share > b.share; });
  }

  /// Nose data that contradict the insert shift every place by another amount, in closed form.
  void tellNose(const DeviationPatch& patch, Finding& finding) const {
    const auto main = std::max_element(
        patch.makers.begin(), patch.makers.end(),
        [](const MakerShare& a, const MakerShare& b) { return a.share * a.depth_mm < b.share * b.depth_mm; });
    if (main == patch.makers.end() || main->maker.motion == kNoMotion || main->depth_mm == 0.0) return;
    const std::uint32_t setup = setupOf(main->maker);
    const RigidTransform to = into(setup);
    const double beyond = patch.kind == DeviationKind::kGouge ? main->depth_mm : -main->depth_mm;
    const auto cause = noseCause(run_.setups[setup], main->maker.motion, to(main->where),
                                 to.rotation * main->normal, beyond);
    constexpr double kMostOfIt = 0.5;
    if (cause && cause->explains >= kMostOfIt) finding.causes.push_back(*cause);
  }

  /// A contour that the middle of a wire has followed is off by half of its kerf all along.
  void tellNoOffset(const DeviationPatch& patch, Finding& finding) const {
    const MakerShare* first = nullptr;
    double share = 0.0;
    for (const MakerShare& m : patch.makers) {
      if (m.maker.motion == kNoMotion) continue;
      const SetupRun& setup = run_.setups[setupOf(m.maker)];
      if (!followsContour(setup.interpreted.path, setup.job.tools, m.maker.motion, m.depth_mm)) continue;
      share += m.share;
      if (first == nullptr || m.maker.motion < first->maker.motion) first = &m;
    }
    constexpr double kMostOfIt = 0.5;
    if (first == nullptr || share < kMostOfIt) return;
    const std::uint32_t setup = setupOf(first->maker);
    const Toolpath& path = run_.setups[setup].interpreted.path;
    const double kerf = halfKerf(path, run_.setups[setup].job.tools, first->maker.motion).value_or(0.0);
    Cause cause;
    cause.what = kNoOffset;
    cause.value = fmt::format("the wire's kerf is {:g} mm to each side", kerf);
    cause.source = writtenBlock(path, first->maker.motion, *sources_[setup]).block;
    cause.along = "radius";
    cause.off_mm = patch.kind == DeviationKind::kGouge ? -kerf : kerf;
    cause.explains = std::min(share, 1.0);
    finding.causes.push_back(std::move(cause));
  }

  /// What no shift of a motion explains was not cut at all: which motion came nearest?
  void tellUncut(const DeviationPatch& patch, Finding& finding) const {
    double least = std::numeric_limits<double>::infinity();
    Cause cause;
    cause.what = kUncut;
    for (std::uint32_t k = 0; k < run_.setups.size(); ++k) {
      const Toolpath& path = run_.setups[k].interpreted.path;
      const Vec3 p = into(k)(patch.where);
      for (const Motion& m : path.motions) {
        const Vec3 way = m.to - m.from;
        const double t = way.isZero() ? 0.0 : std::clamp((p - m.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        const double distance = (m.from + t * way - p).norm();
        if (m.kind == MotionKind::kRapid || distance >= least) continue;
        least = distance;
        cause.source = blockRef(path, m.source, *sources_[k]);
        cause.value = fmt::format("the nearest cut is {:.3g} mm away", distance);
      }
    }
    finding.causes.push_back(std::move(cause));
  }

  void tellInForce(const DeviationPatch& patch, Finding& finding) const {
    const SurfaceMaker maker = mainMaker(patch);
    if (maker.motion == kNoMotion) return;
    const std::uint32_t setup = setupOf(maker);
    std::size_t added = 0;
    for (const CauseCandidate& c : inForce(sourceOf(setup), maker.motion)) {
      if (added++ >= kMostCauses) return;
      finding.causes.push_back(causeOf(c, setup));
    }
  }

  const RunSources& sources_;
  const ExactPart* part_;  ///< null: the mesh says which motion left a triangle
  RunResult& run_;
  std::vector<Point> points_;
  std::unordered_map<std::uint64_t, std::vector<Effect>> effects_;  ///< by clamping and motion
  std::vector<Hypothesis> hypotheses_;
  double off_weight_ = 0.0;
};

}  // namespace

SurfaceMaker mainMaker(const DeviationPatch& patch) {
  SurfaceMaker best = patch.maker;
  double most = 0.0;
  for (const MakerShare& m : patch.makers) {
    const double weight = m.share * m.depth_mm * m.depth_mm;
    if (m.maker.motion == kNoMotion || weight <= most) continue;
    most = weight;
    best = m.maker;
  }
  return best;
}

void diagnoseDeviations(const RunSources& sources, const ExactPart* part,
                        const std::vector<PatchFinding>& patches, RunResult& run) {
  if (patches.empty()) return;
  const Diagnosis diagnosis(sources, part, patches, run);
  for (const PatchFinding& p : patches) diagnosis.tell(p);
}

std::vector<Cause> behindMotion(const SetupRun& setup, const RecordingSource& texts, MotionId motion) {
  const Toolpath& path = setup.interpreted.path;
  const CauseSource source{path, setup.job.tools, partTurns(setup), setup.job.control, lineText(path, texts)};
  std::vector<Cause> out;
  for (const CauseCandidate& c : inForce(source, motion)) out.push_back(Diagnosis::makeCause(c, path, texts));
  return out;
}

/// The words that say how the spindle turns.
static std::vector<Cause> behindSpindle(const SetupRun& setup, const RecordingSource& texts,
                                        MotionId motion) {
  const Toolpath& path = setup.interpreted.path;
  const CauseSource source{path, setup.job.tools, partTurns(setup), setup.job.control, lineText(path, texts)};
  std::vector<Cause> out;
  for (const CauseCandidate& c : spindleWords(source, motion))
    out.push_back(Diagnosis::makeCause(c, path, texts));
  return out;
}

void tellWordsInForce(const RunSources& sources, RunResult& run) {
  for (Finding& finding : run.findings) {
    if (!finding.motion || !finding.causes.empty() || finding.depth_mm == std::nullopt) continue;
    if (finding.kind == FindingKind::kToolData) continue;  // says the cause itself
    const auto setup = std::find_if(run.setups.begin(), run.setups.end(),
                                    [&](const SetupRun& s) { return s.name == finding.setup; });
    if (setup == run.setups.end()) continue;
    const RecordingSource& texts = *sources[static_cast<std::size_t>(setup - run.setups.begin())];
    finding.causes = finding.kind == FindingKind::kSpindleOff ? behindSpindle(*setup, texts, *finding.motion)
                                                              : behindMotion(*setup, texts, *finding.motion);
    finding.causes.resize(std::min(finding.causes.size(), kMostCauses));
  }
}

}  // namespace proveout

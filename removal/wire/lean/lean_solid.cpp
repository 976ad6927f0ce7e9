#include "removal/wire/lean/lean_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/geometry/to_float.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/shells.h"
#include "removal/wire/lean/lean_levels.h"
#include "removal/wire/lean/level_step.h"
#include "removal/wire/lean/part_fans.h"
#include "removal/wire/section/face_triangles.h"

namespace proveout {
namespace {

/// All bodies as one mesh. What bounds one body is found by members: the loops of all levels, then the points
/// of all steps.
class SolidWriter {
 public:
  /// By slab.
  using Steps = std::vector<std::optional<LevelStep>>;

  SolidWriter(const LeanLevels& levels, const Steps& steps) : levels_(levels), steps_(steps) {
    for (const LevelSection& level : levels.levels) {
      first_loop_.push_back(static_cast<std::uint32_t>(first_point_.size()));
      for (const LevelLoop& loop : level.loops) {
        first_point_.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
        for (const Vec2& p : loop.points)
          mesh_.positions.emplace_back(toFloat(p.x()), toFloat(p.y()), toFloat(level.z));
      }
    }
    bendRungs();
    for (const std::optional<LevelStep>& step : steps) {
      first_step_.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
      if (!step) continue;
      for (const Vec2& p : step->points)
        mesh_.positions.emplace_back(toFloat(p.x()), toFloat(p.y()), toFloat(step->z));
    }
  }

  void write() {
    faces(0, false);
    for (std::size_t k = 0; k < levels_.slabs.size(); ++k) {
      for (const Ribbon& ribbon : levels_.slabs[k].ribbons) wall(levels_.slabs[k], ribbon);
      if (steps_[k]) step(k);
    }
    faces(static_cast<std::uint32_t>(levels_.levels.size()) - 1, true);
  }

  std::size_t loops() const { return first_point_.size(); }
  std::size_t members() const { return loops() + mesh_.positions.size() - first_step_.front(); }
  std::uint32_t loop(std::uint32_t level, std::uint32_t k) const { return first_loop_[level] + k; }
  /// Once; members() are to be asked for before.
  TriMesh takeMesh() { return std::move(mesh_); }
  std::uint32_t stepPoint(std::size_t slab, std::uint32_t point) const {
    return static_cast<std::uint32_t>(loops()) + first_step_[slab] - first_step_.front() + point;
  }
  /// By triangle, one of the members that bound its body.
  const std::vector<std::uint32_t>& memberOfTriangle() const { return member_of_; }

 private:
  std::uint32_t point(const LevelPoint& p) const { return first_point_[loop(p.level, p.loop)] + p.point; }

  /// A parabola by height, from point to point.
  struct Curve {
    Vec2 middle = Vec2::Zero();  ///< half way up
    std::uint32_t rows = 1;
    bool between = false;
    std::uint32_t first = 0, points = 0;  ///< that it has between its ends
  };
  using Rung = std::pair<std::uint32_t, std::uint32_t>;

  Vec2 placeOf(std::uint32_t p) const { return mesh_.positions[p].head<2>().cast<double>(); }

  /// Gives curved rungs their points.
  void bendRungs() {
    for (const LevelSplit& split : levels_.splits)
      split_[{point(split.lower), point(split.upper)}] = point(split.middle);
    // What is not split says its own shape; parts of what is split take it from the whole.
    for (const bool of_split : {false, true}) {
      for (const LevelCurve& curve : levels_.curves) {
        const Rung rung{point(curve.lower), point(curve.upper)};
        if (split_.contains(rung) == of_split)
          ask(rung, Curve{curve.middle, curve.rows, curve.between, 0, 0});
      }
    }
    for (auto& [rung, curve] : curve_) addPoints(rung, curve);
  }

  void ask(const Rung& rung, const Curve& curve) {
    const auto split = split_.find(rung);
    if (split == split_.end()) {
      Curve& known = curve_.try_emplace(rung, curve).first->second;
      known.rows = std::max(known.rows, curve.rows);
      return;
    }
    const Vec2 low = placeOf(rung.first), high = placeOf(rung.second);
    Curve half = curve;
    half.rows = (curve.rows + 1) / 2;
    half.middle = 0.375 * low + 0.75 * curve.middle - 0.125 * high;
    ask({rung.first, split->second}, half);
    half.middle = 0.375 * high + 0.75 * curve.middle - 0.125 * low;
    ask({split->second, rung.second}, half);
  }

  void addPoints(const Rung& rung, Curve& curve) {
    const Vec2 low = placeOf(rung.first), high = placeOf(rung.second);
    const double z_low = mesh_.positions[rung.first].z(), z_high = mesh_.positions[rung.second].z();
    curve.first = static_cast<std::uint32_t>(mesh_.positions.size());
    curve.points = curve.rows == 1 ? 0 : curve.between ? curve.rows : curve.rows - 1;
    for (std::uint32_t k = 0; k < curve.points; ++k) {
      const double t = (k + (curve.between ? 0.5 : 1.0)) / curve.rows;
      const Vec2 p =
          (1.0 - t) * (1.0 - 2.0 * t) * low + 4.0 * t * (1.0 - t) * curve.middle + t * (2.0 * t - 1.0) * high;
      mesh_.positions.emplace_back(toFloat(p.x()), toFloat(p.y()), toFloat((1.0 - t) * z_low + t * z_high));
    }
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, MotionId motion, std::uint32_t member) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.motion.push_back(motion);
    member_of_.push_back(member);
  }

  void faces(std::uint32_t level, bool up) {
    const LevelSection& section = levels_.levels[level];
    for (const LevelRegion& region : section.regions) {
      std::vector<std::vector<Vec2>> loops;
      std::vector<std::uint32_t> corner;
      for (const std::uint32_t k : region.loops) {
        std::vector<Vec2>& points = loops.emplace_back();
        for (std::uint32_t i = 0; i < section.loops[k].points.size(); ++i) {
          points.push_back(asFloat(section.loops[k].points[i]));
          corner.push_back(first_point_[loop(level, k)] + i);
        }
      }
      for (const auto& [a, b, c] : faceTriangles(loops)) {
        triangle(corner[a], corner[up ? b : c], corner[up ? c : b], kNoMotion,
                 loop(level, region.loops.front()));
      }
    }
  }

  void wall(const LevelSlab& slab, const Ribbon& ribbon) {
    const std::uint32_t low = loop(slab.lower, ribbon.lower_loop), high = loop(slab.upper, ribbon.upper_loop);
    const LevelLoop& lower = levels_.levels[slab.lower].loops[ribbon.lower_loop];
    const LevelLoop& upper = levels_.levels[slab.upper].loops[ribbon.upper_loop];
    const std::uint32_t a = first_point_[low], b = first_point_[high];
    std::vector<std::uint32_t> here, next;
    for (std::size_t k = 0; k + 1 < ribbon.rungs.size(); ++k) {
      const auto [i, j] = ribbon.rungs[k];
      const auto [next_i, next_j] = ribbon.rungs[k + 1];
      here = {a + i};
      addRung(a + i, b + j, here);
      next = {a + next_i};
      addRung(a + next_i, b + next_j, next);
      strip(here, next, next_i != i ? lower.motions[i] : upper.motions[j], low);
    }
  }

  /// The points of a rung above its lower end.
  void addRung(std::uint32_t low, std::uint32_t high, std::vector<std::uint32_t>& out) const {
    if (const auto split = split_.find({low, high}); split != split_.end()) {
      addRung(low, split->second, out);
      addRung(split->second, high, out);
      return;
    }
    if (const auto curve = curve_.find({low, high}); curve != curve_.end()) {
      for (std::uint32_t k = 0; k < curve->second.points; ++k) out.push_back(curve->second.first + k);
    }
    out.push_back(high);
  }

  /// Between two rungs. Where they meet in a point the triangle there has one of each: a fan about that point
  /// over several points of one rung would lie flat on it.
  void strip(const std::vector<std::uint32_t>& here, const std::vector<std::uint32_t>& next, MotionId motion,
             std::uint32_t member) {
    const auto height = [&](std::uint32_t p) { return mesh_.positions[p].z(); };
    PROVEOUT_ASSERT(here.size() >= 2 && next.size() >= 2);
    std::size_t i = 0, j = 0, end_i = here.size() - 1, end_j = next.size() - 1;
    const bool closes = here.back() == next.back();
    if (here.front() == next.front()) {
      triangle(here[0], next[1], here[1], motion, member);
      i = j = 1;
    } else if (closes) {
      --end_i;
      --end_j;
    }
    while (i < end_i || j < end_j) {
      const bool left = j == end_j || (i < end_i && height(here[i + 1]) <= height(next[j + 1]));
      triangle(here[i], next[j], left ? here[i + 1] : next[j + 1], motion, member);
      ++(left ? i : j);
    }
    if (closes) triangle(here[i], next[j], here.back(), motion, member);
  }

  /// The face, and the walls that end at it and begin there.
  void step(std::size_t k) {
    const LevelStep& step = *steps_[k];
    const LevelSlab& slab = levels_.slabs[k];
    PROVEOUT_ASSERT(step.lower.size() == slab.lower_alone.size() && step.upper.size() == slab.upper_alone.size());
    const std::uint32_t first = first_step_[k];
    for (const auto& [a, b, c] : step.triangles)
      triangle(first + a, first + b, first + c, kNoMotion, stepPoint(k, a));
    for (std::size_t i = 0; i < step.lower.size(); ++i)
      stepWall(step.lower[i], first, slab.lower, slab.lower_alone[i], false);
    for (std::size_t i = 0; i < step.upper.size(); ++i)
      stepWall(step.upper[i], first, slab.upper, slab.upper_alone[i], true);
  }

  void stepWall(const LevelStep::Chains& chains, std::uint32_t first, std::uint32_t level, std::uint32_t k,
                bool above) {
    const LevelLoop& loop_at = levels_.levels[level].loops[k];
    const std::uint32_t member = loop(level, k), base = first_point_[member];
    PROVEOUT_ASSERT(chains.size() == loop_at.points.size());
    for (std::uint32_t i = 0; i < chains.size(); ++i) {
      const std::uint32_t a = base + i, b = base + (i + 1) % static_cast<std::uint32_t>(chains.size());
      const std::vector<std::uint32_t>& chain = chains[i];
      for (std::size_t j = 0; j + 1 < chain.size(); ++j) {
        const std::uint32_t u = first + chain[above ? j : j + 1], v = first + chain[above ? j + 1 : j];
        triangle(a, u, v, loop_at.motions[i], member);
      }
      const std::uint32_t end = first + chain.back();
      triangle(end, above ? b : a, above ? a : b, loop_at.motions[i], member);
    }
  }

  const LeanLevels& levels_;
  const Steps& steps_;
  TriMesh mesh_;
  std::vector<std::uint32_t> first_loop_;   ///< by level
  std::vector<std::uint32_t> first_point_;  ///< by loop of all levels
  std::vector<std::uint32_t> first_step_;   ///< by slab
  std::vector<std::uint32_t> member_of_;
  /// By the ends of a rung: a point on it.
  std::map<Rung, std::uint32_t> split_;
  std::map<Rung, Curve> curve_;
};

/// Which members bound one body.
class Bodies {
 public:
  Bodies(const LeanLevels& levels, const SolidWriter::Steps& steps, const SolidWriter& writer)
      : sets_(writer.members()) {
    for (std::uint32_t level = 0; level < levels.levels.size(); ++level) {
      for (const LevelRegion& region : levels.levels[level].regions) {
        for (const std::uint32_t k : region.loops)
          sets_.join(writer.loop(level, region.loops.front()), writer.loop(level, k));
      }
    }
    for (const LevelSlab& slab : levels.slabs) {
      for (const Ribbon& ribbon : slab.ribbons)
        sets_.join(writer.loop(slab.lower, ribbon.lower_loop), writer.loop(slab.upper, ribbon.upper_loop));
    }
    for (const PassedLoop& p : levels.passed)
      sets_.join(writer.loop(p.level, p.loop), writer.loop(p.other_level, p.other_loop));
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (!steps[k]) continue;
      const LevelSlab& slab = levels.slabs[k];
      join(writer, k, steps[k]->lower, slab.lower, slab.lower_alone);
      join(writer, k, steps[k]->upper, slab.upper, slab.upper_alone);
      for (const auto& [a, b, c] : steps[k]->triangles) {
        sets_.join(writer.stepPoint(k, a), writer.stepPoint(k, b));
        sets_.join(writer.stepPoint(k, a), writer.stepPoint(k, c));
      }
    }
  }
  /// A loop: they come first.
  std::uint32_t of(std::uint32_t member) { return sets_.find(member); }

 private:
  void join(const SolidWriter& writer, std::size_t slab, const std::vector<LevelStep::Chains>& loops,
            std::uint32_t level, const std::vector<std::uint32_t>& alone) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      for (const std::vector<std::uint32_t>& chain : loops[i]) {
        for (const std::uint32_t p : chain)
          sets_.join(writer.loop(level, alone[i]), writer.stepPoint(slab, p));
      }
    }
  }

  DisjointSets sets_;
};

Result<SolidWriter::Steps> stepsOf(const LeanLevels& levels) {
  SolidWriter::Steps steps(levels.slabs.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const LevelSlab& slab = levels.slabs[k];
    if (slab.lower_alone.empty() && slab.upper_alone.empty()) continue;
    const LevelSection &lower = levels.levels[slab.lower], &upper = levels.levels[slab.upper];
    steps[k] = levelStep(lower, slab.lower_alone, upper, slab.upper_alone);
    if (steps[k]) continue;
    const Vec2 at = slab.lower_alone.empty() ? upper.loops[slab.upper_alone.front()].points.front()
                                             : lower.loops[slab.lower_alone.front()].points.front();
    return inputError(
        fmt::format("walls of the leaning wire's cut meet at the height z = {:.3f}, near x = {:.3f} "
                    "y = {:.3f}, so that no closed surface could be made",
                    lower.z, at.x(), at.y()));
  }
  return steps;
}

/// By member: what its body has.
std::vector<double> volumesOf(const LeanLevels& levels, const SolidWriter& writer, Bodies& bodies) {
  std::vector<double> volume(writer.loops());
  for (const LevelSlab& slab : levels.slabs) {
    for (const LevelSlab::Volume& wall : slab.volumes)
      volume[bodies.of(writer.loop(slab.lower, wall.lower_loop))] += wall.mm3;
    const auto add = [&](std::uint32_t level, const std::vector<std::uint32_t>& alone) {
      const double half = 0.5 * (levels.levels[slab.upper].z - levels.levels[slab.lower].z);
      for (const std::uint32_t k : alone)
        volume[bodies.of(writer.loop(level, k))] += half * areaOf(levels.levels[level].loops[k]);
    };
    add(slab.lower, slab.lower_alone);
    add(slab.upper, slab.upper_alone);
  }
  return volume;
}

/// All but the levels.
Result<LeanSolid> solidOf(const LeanLevels& levels) {
  const Result<SolidWriter::Steps> steps = stepsOf(levels);
  if (!steps) return steps.error();
  SolidWriter writer(levels, *steps);
  writer.write();
  Bodies bodies(levels, *steps, writer);
  const std::vector<double> volume = volumesOf(levels, writer, bodies);
  std::vector<std::uint32_t> roots;
  for (std::uint32_t loop = 0; loop < writer.loops(); ++loop) {
    if (bodies.of(loop) == loop) roots.push_back(loop);
  }
  std::stable_sort(roots.begin(), roots.end(), [&](auto a, auto b) { return volume[a] > volume[b]; });
  std::vector<std::uint32_t> number(writer.loops());
  LeanSolid out;
  for (const std::uint32_t root : roots) {
    number[root] = static_cast<std::uint32_t>(out.bodies.size());
    out.bodies.emplace_back().volume_mm3 = volume[root];
  }
  Shells shells;
  shells.count = static_cast<std::uint32_t>(out.bodies.size());
  for (const std::uint32_t member : writer.memberOfTriangle()) {
    const std::uint32_t root = bodies.of(member);
    PROVEOUT_ASSERT(root < number.size());  // a loop
    shells.shell_of.push_back(number[root]);
  }
  shells.mesh = writer.takeMesh();
  std::vector<TriMesh> meshes = shellMeshes(shells);
  PROVEOUT_ASSERT(meshes.size() == out.bodies.size());
  for (std::size_t k = 0; k < meshes.size(); ++k) out.bodies[k].mesh = std::move(meshes[k]);
  // Only steps share vertices.
  const bool stepped = std::any_of(steps->begin(), steps->end(), [](const auto& s) { return s.has_value(); });
  for (LeanBody& body : out.bodies) {
    if (stepped) partFans(body.mesh);
  }
  for (std::uint32_t level = 0; level < levels.levels.size(); ++level) {
    std::vector<std::uint32_t>& of = out.body_of.emplace_back();
    for (const LevelRegion& region : levels.levels[level].regions)
      of.push_back(number[bodies.of(writer.loop(level, region.loops.front()))]);
  }
  return out;
}

std::vector<CrossedTriangle> crossedOf(const std::vector<LeanBody>& bodies) {
  if (bodies.size() == 1) return crossedTriangles(bodies.front().mesh);
  TriMesh all;
  for (const LeanBody& body : bodies) append(all, body.mesh);
  return crossedTriangles(all);
}

}  // namespace

Result<LeanSolid> leanSolid(const std::vector<PlaneLoop>& blank, const HeightSpan& span,
                            const std::vector<LeanStretch>& stretches, double tolerance, Progress& progress) {
  LeanSolid best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  const auto use = [&](LeanLevels& levels) -> Result<std::vector<CrossedTriangle>> {
    Result<LeanSolid> solid = solidOf(levels);
    if (!solid) return solid.error();
    std::vector<CrossedTriangle> crossed = crossedOf(solid->bodies);
    if (crossed.size() < least) {
      least = crossed.size();
      best = std::move(*solid);
      best.runs_through_itself = least > 0;
      if (least == 0)
        best.levels = std::move(levels.levels);
      else
        best.levels = levels.levels;
    }
    return crossed;
  };
  const Status done = leanLevels(
      [&](double z, ThinPlaces thin) { return levelSection(blank, atHeight(stretches, span, z), z, thin); },
      span.low, span.high, tolerance, use, progress);
  if (!done) return done.error();
  PROVEOUT_ASSERT(!best.levels.empty() && best.body_of.size() == best.levels.size());
  return best;
}

std::size_t levelAt(const LeanSolid& solid, double z) {
  PROVEOUT_ASSERT(!solid.levels.empty());
  const auto nearest =
      std::min_element(solid.levels.begin(), solid.levels.end(),
                       [&](const auto& a, const auto& b) { return std::abs(a.z - z) < std::abs(b.z - z); });
  return static_cast<std::size_t>(nearest - solid.levels.begin());
}

std::vector<std::vector<Vec2>> outlineOf(const LeanSolid& solid, std::size_t body, double z) {
  std::vector<std::vector<Vec2>> out;
  const std::size_t level = levelAt(solid, z);
  const LevelSection& section = solid.levels[level];
  PROVEOUT_ASSERT(solid.body_of[level].size() == section.regions.size());
  for (std::size_t region = 0; region < section.regions.size(); ++region) {
    if (solid.body_of[level][region] != body) continue;
    for (const std::uint32_t loop : section.regions[region].loops) out.push_back(section.loops[loop].points);
  }
  return out;
}

}  // namespace proveout

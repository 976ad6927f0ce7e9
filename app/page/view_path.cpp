#include "app/page/view_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/session/findings/provenance.h"
#include "core/path/posed_way.h"
#include "core/tool/tool_solid.h"
#include "core/tool/tool_table.h"
#include "core/tool/tool_type.h"

namespace proveout {

namespace {

/// Texts of programs beyond this stay out of the page, bytes.
constexpr std::size_t kMostText = 1'500'000;
/// Chords turn by at most so much, rad, and leave an arc by at most so much of the part's size.
constexpr double kMostTurn = 0.2, kChordShare = 2e-4;
constexpr int kMostChords = 400;
/// Chords of a motion during which the tool's axis turns.
constexpr int kPosedChords = 8;

/// The outline of the parts of a tool, one above the other, below `top`.
void addOutline(const std::vector<ConvexProfile>& parts, double top, std::vector<Vec2>& outline) {
  constexpr int kArcSteps = 8;
  const auto add = [&](double r, double z) { outline.emplace_back(r, std::min(z, top)); };
  for (const ConvexProfile& part : parts) {
    if (part.zMin() >= top) continue;
    add(part.element(0).ar, part.element(0).az);
    for (int i = 0; i < part.elementCount(); ++i) {
      const ConvexProfile::Element& e = part.element(i);
      if (e.arc) {
        const double from = std::atan2(e.az - e.cz, e.ar - e.cr), to = std::atan2(e.bz - e.cz, e.br - e.cr);
        for (int k = 1; k < kArcSteps; ++k) {
          const double a = from + (to - from) * k / kArcSteps;
          add(e.cr + e.radius * std::cos(a), e.cz + e.radius * std::sin(a));
        }
      }
      add(e.br, e.bz);
    }
  }
}

/// `size_mm`: of the part, which a wire and a tool without an upper end are drawn as long as.
ViewPath::Tool viewTool(int number, const Tool* tool, double size_mm) {
  if (tool == nullptr) return {number == 0 ? "no tool" : fmt::format("T{}", number), {}};
  ViewPath::Tool out{fmt::format("T{} {}", number, describe(*tool)), {}};
  if (tool->type == ToolType::kWire) {
    const double r = std::max(0.5 * tool->diameter, 2e-3 * size_mm);
    out.outline = {{0.0, -0.3 * size_mm}, {r, -0.3 * size_mm}, {r, size_mm}, {0.0, size_mm}};
  } else if (rowOf(tool->type).rotates) {
    const ToolSolid solid = makeToolSolid(*tool);
    const double top =
        tool->overall_length > 0.0 ? kUnlimitedFluteMm : std::max(size_mm, 3.0 * tool->diameter);
    addOutline(solid.cutter, top, out.outline);
    addOutline(solid.shank, top, out.outline);
    addOutline(solid.holder, top, out.outline);
  }
  return out;
}

ViewMove moveOf(MotionKind kind) {
  switch (kind) {
    case MotionKind::kRapid:
      return ViewMove::kRapid;
    case MotionKind::kThread:
      return ViewMove::kThread;
    case MotionKind::kProbe:
      return ViewMove::kProbe;
    case MotionKind::kFeed:
      break;
  }
  return ViewMove::kFeed;
}

struct PosePoint {
  Vec3 at, axis;
};

Vec3 onTrack(const WireTrack& track, double share, double z) {
  if (track.sweep_rad == 0.0) {
    const Vec2 p = track.from + share * (track.to - track.from);
    return {p.x(), p.y(), z};
  }
  const Vec2 from = track.from - track.center, to = track.to - track.center;
  const double a = std::atan2(from.y(), from.x()) + share * track.sweep_rad;
  const double r = from.norm() + share * (to.norm() - from.norm());
  return {track.center.x() + r * std::cos(a), track.center.y() + r * std::sin(a), z};
}

/// Points of one clamping's motions in its own frame.
class MotionPoints {
 public:
  MotionPoints(const Toolpath& path, double size_mm) : path_(path), size_mm_(size_mm) {}

  int chords(const Motion& m) const {
    const bool poses = m.axis >= 0 && !path_.axes[static_cast<std::size_t>(m.axis)].alongZ();
    int count = poses ? kPosedChords : 1;
    double sweep = 0.0, radius = 0.0;
    if (m.wire >= 0) {
      const WireSweep& wire = path_.wires[static_cast<std::size_t>(m.wire)];
      for (const WireTrack* track : {&wire.lower, &wire.upper}) {
        sweep = std::max(sweep, std::abs(track->sweep_rad));
        if (track->sweep_rad != 0.0) radius = std::max(radius, (track->from - track->center).norm());
      }
    } else if (m.arc >= 0) {
      const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(m.arc)];
      const ArcFrame frame = arcFrame(m.from, m.to, arc);
      sweep = std::abs(arc.sweep_rad);
      radius = std::max(frame.radius_start, frame.radius_end);
    }
    if (sweep > 0.0 && radius > 0.0) {
      const double turn =
          std::min(kMostTurn, 2.0 * std::acos(std::clamp(1.0 - kChordShare * size_mm_ / radius, 0.0, 1.0)));
      count = std::max(count, static_cast<int>(std::min<double>(kMostChords, std::ceil(sweep / turn))));
    }
    return count;
  }

  PosePoint at(const Motion& m, double share) const {
    if (m.wire >= 0) {
      const WireSweep& wire = path_.wires[static_cast<std::size_t>(m.wire)];
      const Vec3 low = onTrack(wire.lower, share, wire.z_low), high = onTrack(wire.upper, share, wire.z_high);
      return {low, (high - low).normalized()};
    }
    if (m.axis < 0) return {path_.pointAt(m, share), Vec3::UnitZ()};
    const AxisSweep& sweep = path_.axes[static_cast<std::size_t>(m.axis)];
    if (sweep.alongZ()) return {path_.pointAt(m, share), Vec3::UnitZ()};
    const ArcGeometry* arc = m.arc < 0 ? nullptr : &path_.arcs[static_cast<std::size_t>(m.arc)];
    const ToolPose pose = PosedWay(m, arc, sweep).at(share);
    return {pose.tip, pose.axis};
  }

 private:
  const Toolpath& path_;
  double size_mm_;
};

}  // namespace

/// Writes the path of a run with points at least `spacing_mm` apart; stops where there are too many.
class PathTracer {
 public:
  PathTracer(PathOfRun& out, const RunResult& run, double size_mm, double spacing_mm, std::size_t most)
      : out_(out), run_(run), size_mm_(size_mm), spacing_mm_(spacing_mm), most_(most) {
    path_.off_mm = spacing_mm;
    out_.block_of_motion_.assign(run.setups.size(), {});
  }

  bool run() {
    for (setup_ = 0; setup_ < run_.setups.size(); ++setup_) {
      if (!addSetup()) return false;
    }
    if (!turns_) path_.axes.clear();
    if (!path_.points.empty()) out_.path_ = std::move(path_);
    return true;
  }

 private:
  bool addSetup() {
    const SetupRun& setup = run_.setups[setup_];
    const Toolpath& path = setup.interpreted.path;
    const auto first_file = static_cast<std::uint32_t>(path_.files.size());
    path_.setups.push_back(setup.name);
    path_.files.insert(path_.files.end(), path.files.begin(), path.files.end());
    const MotionPoints points(path, size_mm_);
    std::vector<std::uint32_t>& blocks = out_.block_of_motion_[setup_];
    blocks.reserve(path.motions.size());
    const Motion* before = nullptr;
    for (const Motion& motion : path.motions) {
      const bool same =
          before != nullptr && sameBlock(before->source, motion.source) && before->tool == motion.tool;
      if (!same) startBlock(motion, first_file);
      addMotion(points, motion, before);
      blocks.push_back(static_cast<std::uint32_t>(path_.blocks.size() - 1));
      before = &motion;
      if (path_.points.size() > most_) return false;
    }
    dropEmptyBlock();
    return true;
  }

  /// A block whose points all were left out is told as part of the next one.
  void dropEmptyBlock() {
    if (!path_.blocks.empty() && path_.blocks.back().first == path_.points.size()) path_.blocks.pop_back();
  }

  void startBlock(const Motion& motion, std::uint32_t first_file) {
    dropEmptyBlock();
    path_.blocks.push_back({static_cast<std::uint32_t>(setup_), first_file + motion.source.file,
                            toolOf(motion.tool), motion.source.line, motion.source.block,
                            path_.points.size()});
  }

  std::uint32_t toolOf(int number) {
    const auto [entry, is_new] =
        tools_.try_emplace({setup_, number}, static_cast<std::uint32_t>(path_.tools.size()));
    if (is_new)
      path_.tools.push_back(
          viewTool(number, ToolTable(run_.setups[setup_].job.tools).find(number), size_mm_));
    return entry->second;
  }

  void addMotion(const MotionPoints& points, const Motion& motion, const Motion* before) {
    const int chords = points.chords(motion);
    const PosePoint from = points.at(motion, 0.0);
    if (before == nullptr || (from.at - last_own_).norm() > 1e-6 * size_mm_) add(from, ViewMove::kStart);
    const double start_s = time_s_;
    for (int k = 1; k <= chords; ++k) {
      const double share = static_cast<double>(k) / chords;
      const PosePoint point = points.at(motion, share);
      time_s_ = start_s + share * motion.time_s;
      last_own_ = point.at;
      const bool far = spacing_mm_ == 0.0 ||
                       (inLastFrame(run_, setup_, point.at) - path_.points.back().at).norm() >= spacing_mm_;
      if (far) add(point, moveOf(motion.kind));
    }
  }

  void add(const PosePoint& point, ViewMove move) {
    const Vec3 at = inLastFrame(run_, setup_, point.at);
    const Vec3 axis = inLastFrame(run_, setup_, point.at + point.axis) - at;
    turns_ = turns_ || (axis - Vec3::UnitZ()).norm() > 1e-9;
    path_.points.push_back({at, time_s_, move});
    path_.axes.push_back(axis);
  }

  PathOfRun& out_;
  const RunResult& run_;
  double size_mm_, spacing_mm_;
  std::size_t most_;
  ViewPath path_;
  std::size_t setup_ = 0;
  double time_s_ = 0.0;
  bool turns_ = false;
  Vec3 last_own_ = Vec3::Zero();  ///< end of the motion before, in the clamping's frame
  std::map<std::pair<std::size_t, int>, std::uint32_t> tools_;
};

namespace {

/// Lines of the files as far as blocks name them.
void addTexts(const RunSources& sources, ViewPath& path) {
  std::vector<std::uint32_t> lines(path.files.size(), 0), setups(path.files.size(), 0);
  for (const ViewPath::Block& block : path.blocks) {
    lines[block.file] = std::max(lines[block.file], block.line);
    setups[block.file] = block.setup;
  }
  std::size_t bytes = 0;
  for (std::size_t f = 0; f < path.files.size(); ++f) {
    std::vector<std::string> text;
    for (std::uint32_t n = 1; n <= lines[f] && bytes < kMostText; ++n) {
      text.push_back(sources[setups[f]]->line(path.files[f], n));
      bytes += text.back().size() + 1;
    }
    path.texts.push_back(std::move(text));
  }
}

double lengthOf(const RunResult& run) {
  double length = 0.0;
  for (const SetupRun& setup : run.setups) {
    for (const Motion& motion : setup.interpreted.path.motions) length += (motion.to - motion.from).norm();
  }
  return length;
}

std::size_t motionsOf(const RunResult& run) {
  std::size_t count = 0;
  for (const SetupRun& setup : run.setups) count += setup.interpreted.path.motions.size();
  return count;
}

}  // namespace

PathOfRun::PathOfRun(const RunResult& run, const RunSources& sources, std::size_t most_points) : run_(run) {
  const double size = meshBounds(run.surface().mesh).size().norm();
  double spacing =
      motionsOf(run) > most_points ? 0.5 * lengthOf(run) / static_cast<double>(most_points) : 0.0;
  const double least = std::max(1e-5 * size, 1e-6 * lengthOf(run));
  while (!PathTracer(*this, run, size, spacing, most_points).run()) spacing = std::max(least, 1.6 * spacing);
  if (path_) addTexts(sources, *path_);
}

std::int64_t PathOfRun::blockOf(const Finding& finding) const {
  if (!path_) return -1;
  for (std::size_t k = 0; k < run_.setups.size(); ++k) {
    if (run_.setups[k].name != finding.setup) continue;
    if (finding.motion && *finding.motion < block_of_motion_[k].size()) {
      return std::min<std::int64_t>(block_of_motion_[k][*finding.motion],
                                    static_cast<std::int64_t>(path_->blocks.size()) - 1);
    }
    if (!finding.source) continue;
    for (std::size_t i = 0; i < path_->blocks.size(); ++i) {
      const ViewPath::Block& block = path_->blocks[i];
      if (block.setup == k && block.line == finding.source->line &&
          path_->files[block.file] == finding.source->file)
        return static_cast<std::int64_t>(i);
    }
  }
  return -1;
}

}  // namespace proveout

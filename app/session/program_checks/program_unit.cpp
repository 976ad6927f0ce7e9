#include "app/session/program_checks/program_unit.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/session/run/process.h"

namespace proveout {
namespace {

constexpr double kMmPerInch = 25.4;
/// Share of the blank that a program goes over which is meant for it, and how far it may go beyond, as a
/// share of the blank: approaches and cutters' radii.
constexpr double kLeastCover = 0.5, kBeyond = 0.25;

/// Bounds of the feeds.
Box3 feedBounds(const Toolpath& path) {
  Box3 bounds;
  for (const Motion& motion : path.motions) {
    if (motion.kind != MotionKind::kRapid) bounds.extend(path.bounds(motion));
  }
  return bounds;
}

/// The blank in the two directions in which programs go over it: of a part that turns the radius, and along
/// Z.
struct Face {
  std::array<int, 2> axes;
  Box3 blank;
};

Face faceOf(const CheckedProgram& program) {
  Face face{{0, 1}, *program.blank};
  if (!processOf(program.job.control).part_turns) return face;
  face.axes[1] = 2;
  face.blank.min.x() = 0.0;
  return face;
}

/// Whether feeds with these bounds, made larger by `scale`, are such as for the blank.
bool fits(const Box3& feeds, double scale, const Face& face) {
  for (const int axis : face.axes) {
    const double low = scale * feeds.min[axis], high = scale * feeds.max[axis];
    const double size = face.blank.max[axis] - face.blank.min[axis], beyond = kBeyond * size;
    if (high - low < kLeastCover * size) return false;
    if (low < face.blank.min[axis] - beyond || high > face.blank.max[axis] + beyond) return false;
  }
  return true;
}

/// How deep they go stays within the blank, of what comes from above.
bool staysInDepth(const Box3& feeds, double scale, const CheckedProgram& program) {
  if (!processOf(program.job.control).from_above) return true;
  const double height = program.blank->max.z() - program.blank->min.z();
  return scale * feeds.min.z() >= program.blank->min.z() - kBeyond * height &&
         scale * feeds.min.z() <= program.blank->max.z();
}

MotionId firstFeed(const Toolpath& path) {
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    if (path.motions[id].kind != MotionKind::kRapid) return id;
  }
  return kNoMotion;
}

/// Who said in which unit the program is read.
std::string unitSaid(const CheckedProgram& program, MotionId motion, Finding& finding) {
  const Toolpath& path = program.path;
  if (path.motions[motion].source.origins >= 0) {
    const LineText text = lineText(path, program.texts);
    if (const auto word = originOf(path, motion, OriginKind::kUnits, text)) {
      SourceRef source;
      source.file = word->file;
      source.line = word->line;
      source.block = word->block;
      source.depth = word->depth;
      finding.source = blockRef(path, source, program.texts);
      return fmt::format("is {} right?", word->text);
    }
  }
  const bool inch = program.job.settings.units == LengthUnit::kInch;
  return fmt::format("the program does not say its unit, and the job's power-on unit is \"{}\"",
                     inch ? "inch" : "mm");
}

}  // namespace

void addProgramUnit(const CheckedProgram& program, std::vector<Finding>& findings) {
  if (!program.blank) return;
  const Box3 feeds = feedBounds(program.path);
  if (feeds.empty()) return;
  const Face face = faceOf(program);
  const bool small = fits(feeds, kMmPerInch, face) && staysInDepth(feeds, kMmPerInch, program);
  const bool large =
      !small && fits(feeds, 1.0 / kMmPerInch, face) && staysInDepth(feeds, 1.0 / kMmPerInch, program);
  if (!small && !large) return;
  const MotionId first = firstFeed(program.path);
  Finding finding = findingAt(FindingKind::kProgramUnit, first, program);
  const Vec3 reach = feeds.size(), blank = face.blank.size();
  const auto [a, b] = face.axes;
  const std::string unit = unitSaid(program, first, finding);
  finding.message = fmt::format(
      "the feeds go over {:.3g} by {:.3g} mm, the blank has {:.3g} by {:.3g} mm: a program in {} would fit, "
      "{}",
      reach[a], reach[b], blank[a], blank[b],
      small ? "inches read as millimetres" : "millimetres read as inches", unit);
  findings.push_back(std::move(finding));
}

}  // namespace proveout

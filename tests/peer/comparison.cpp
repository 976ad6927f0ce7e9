#include "tests/peer/comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/registry/interpreter.h"
#include "io/program_files.h"

namespace proveout::peer {
namespace {

constexpr double kSame = 1e-6;

/// What is told where the interpreter has a fault that is not followed (docs/reference, differences).
constexpr std::array kFaults = {"linuxcnc-units-with-length", "linuxcnc-turn-with-shift",
                                "linuxcnc-cycle-plane"};

/// Without motions that go nowhere.
std::vector<PeerMotion> moving(const std::vector<PeerMotion>& motions) {
  std::vector<PeerMotion> all;
  Vec3 at = Vec3::Zero();
  for (const PeerMotion& m : motions) {
    if (m.kind == 'A' || (m.to - at).cwiseAbs().maxCoeff() > kSame) all.push_back(m);
    at = m.to;
  }
  return all;
}

bool same(const PeerMotion& theirs, const PeerMotion& ours) {
  if (theirs.kind != ours.kind || (theirs.to - ours.to).cwiseAbs().maxCoeff() > kSame) return false;
  if (theirs.kind != 'A') return true;
  const double radius = (theirs.to - ours.center).norm();
  return (theirs.center - ours.center).cwiseAbs().maxCoeff() <= kSame &&
         (theirs.sweep - ours.sweep).norm() * radius <= 10.0 * kSame;
}

std::string shown(const std::vector<PeerMotion>& of, std::size_t i) {
  if (i >= of.size()) return "none";
  const PeerMotion& m = of[i];
  std::string text = fmt::format("{} {:.7g} {:.7g} {:.7g}", m.kind, m.to.x(), m.to.y(), m.to.z());
  if (m.kind == 'A')
    text += fmt::format(" c {:.7g} {:.7g} {:.7g} by {:.6g}", m.center.x(), m.center.y(), m.center.z(),
                        m.sweep.norm() * 180.0 / M_PI);
  if (m.line > 0) text += fmt::format(" (line {})", m.line);
  return text;
}

PeerMotion motionOf(const Toolpath& path, const Motion& m) {
  PeerMotion motion;
  motion.kind = m.arc >= 0 ? 'A' : m.kind == MotionKind::kRapid ? 'R' : 'F';
  motion.to = m.to;
  motion.line = static_cast<int>(m.source.line);
  if (m.arc < 0) return motion;
  const ArcGeometry& arc = path.arcs[static_cast<std::size_t>(m.arc)];
  motion.center = arc.center;
  motion.sweep = arc.sweep_rad * arc.normal;
  return motion;
}

Verdict compareRuns(const PeerRun& theirs, const PeerRun& ours, std::string& what) {
  const auto a = moving(theirs.motions), b = moving(ours.motions);
  std::size_t k = 0;
  while (k < std::min(a.size(), b.size()) && same(a[k], b[k])) ++k;
  what = fmt::format("motion {}: interpreter {}, here {}; errors: '{}', '{}'", k, shown(a, k), shown(b, k),
                     theirs.error, ours.error);
  if (theirs.error.empty() != ours.error.empty()) return Verdict::kDifferent;
  if (!theirs.error.empty())
    return k >= std::min(a.size(), b.size()) ? Verdict::kSameRefusal : Verdict::kDifferent;
  return k == a.size() && k == b.size() ? Verdict::kSame : Verdict::kDifferent;
}

}  // namespace

const std::vector<PeerTool>& peerTools() {
  static const std::vector<PeerTool> tools = {{1, 50.0, 10.0}, {2, 30.0, 6.0}};
  return tools;
}

Ours runHere(const std::string& path, const std::string& table) {
  ControlSettings settings;
  settings.start = Vec3::Zero();
  if (!table.empty()) {
    settings.parameters["units"] = 1.0;
    settings.texts["tool_table"] = table;
  }
  for (const PeerTool& t : table.empty() ? peerTools() : std::vector<PeerTool>()) {
    settings.length_offsets[t.number] = {t.z, 0.0};
    settings.radius_offsets[t.number] = {t.diameter / 2.0, 0.0};
  }
  Toolpath toolpath;
  ToolpathBuilder sink(toolpath);
  interpret(ControlId::kLinuxCnc, FileProgramSource(path), settings, sink);
  Ours ours;
  for (const Motion& m : toolpath.motions) ours.run.motions.push_back(motionOf(toolpath, m));
  for (const Diagnostic& d : toolpath.diagnostics.all()) {
    ours.told.insert(d.code);
    if (d.severity != Severity::kError) continue;
    if (!ours.run.error.empty()) continue;
    ours.run.error = d.code + ": " + d.message;
    ours.line = static_cast<int>(d.where.line);
  }
  return ours;
}

Verdict compare(const PeerRun& theirs, const Ours& ours, std::string& what) {
  PeerRun heard = theirs;
  // Told here as a warning, as a program without an end has run to it.
  const bool no_end = theirs.error.starts_with("File ended with no percent sign");
  if (no_end && ours.told.contains("linuxcnc-no-end")) heard.error.clear();
  const Verdict verdict = compareRuns(heard, ours.run, what);
  const auto told = [&](const char* code) { return ours.told.contains(code); };
  const bool known = verdict == Verdict::kDifferent && std::ranges::any_of(kFaults, told);
  return known ? Verdict::kFault : verdict;
}

}  // namespace proveout::peer

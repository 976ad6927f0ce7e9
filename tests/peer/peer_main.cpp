// peer COUNT SEED FOLDER: random programs here and in LinuxCNC's interpreter. A program that both refuse is
// run again without the line that was refused, until it runs.
#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "tests/peer/programs.h"
#include "tests/peer/rs274.h"
#include "tests/unit/nc/iso_run.h"

namespace proveout::peer {
namespace {

/// The interpreter prints four decimals; frames and turns add a few of them up.
constexpr double kPrinted = 3e-4;

struct Ours {
  PeerRun run;
  int line = 0;  ///< of the error
};

Ours runHere(const std::string& program) {
  ControlSettings settings = test::runAtZero();
  settings.length_offsets = {{1, {50.0, 0.0}}, {2, {30.0, 0.0}}};
  settings.radius_offsets = {{1, {5.0, 0.0}}, {2, {3.0, 0.0}}};
  const test::IsoRun run(ControlId::kLinuxCnc, program, settings);
  Ours ours;
  for (const Motion& m : run.path.motions) {
    PeerMotion motion;
    motion.kind = m.arc >= 0 ? 'A' : m.kind == MotionKind::kRapid ? 'R' : 'F';
    motion.to = m.to;
    if (m.arc >= 0) motion.center = run.path.arcs[static_cast<std::size_t>(m.arc)].center;
    ours.run.motions.push_back(motion);
  }
  const Diagnostic error = run.first(Severity::kError);
  ours.run.error = error.code.empty() ? "" : error.code + ": " + error.message;
  ours.line = static_cast<int>(error.where.line);
  return ours;
}

/// Without motions that go nowhere.
std::vector<PeerMotion> moving(const std::vector<PeerMotion>& motions) {
  std::vector<PeerMotion> all;
  Vec3 at = Vec3::Zero();
  for (const PeerMotion& m : motions) {
    if (m.kind == 'A' || (m.to - at).cwiseAbs().maxCoeff() > kPrinted) all.push_back(m);
    at = m.to;
  }
  return all;
}

bool same(const PeerMotion& theirs, const PeerMotion& ours) {
  if (theirs.kind != ours.kind || (theirs.to - ours.to).cwiseAbs().maxCoeff() > kPrinted) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const bool counts = theirs.kind == 'A' && theirs.center_axes[static_cast<std::size_t>(axis)];
    if (counts && std::abs(theirs.center[axis] - ours.center[axis]) > kPrinted) return false;
  }
  return true;
}

enum class Verdict { kSame, kSameRefusal, kDifferent };

Verdict compare(const PeerRun& theirs, const PeerRun& ours, std::string& what) {
  const auto a = moving(theirs.motions), b = moving(ours.motions);
  std::size_t k = 0;
  while (k < std::min(a.size(), b.size()) && same(a[k], b[k])) ++k;
  const auto shown = [](const std::vector<PeerMotion>& of, std::size_t i) {
    return i < of.size() ? fmt::format("{} {}", of[i].kind, test::IsoRun::shown(of[i].to))
                         : std::string("none");
  };
  what = fmt::format("motion {}: interpreter {}, here {}; errors: '{}', '{}'", k, shown(a, k), shown(b, k),
                     theirs.error, ours.error);
  if (theirs.error.empty() != ours.error.empty()) return Verdict::kDifferent;
  if (!theirs.error.empty())
    return k >= std::min(a.size(), b.size()) ? Verdict::kSameRefusal : Verdict::kDifferent;
  return k == a.size() && k == b.size() ? Verdict::kSame : Verdict::kDifferent;
}

std::string textOf(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

int compareAll(int count, std::uint64_t seed, const std::string& folder) {
  std::map<Verdict, int> found;
  for (int k = 0; k < count; ++k) {
    std::vector<std::string> lines = randomProgram(seed * 1000003u + static_cast<std::uint64_t>(k));
    for (int round = 0; round < 20; ++round) {
      const std::string text = textOf(lines);
      const auto theirs = runInterpreter(text, folder + "/run");
      if (!theirs) return 2;
      const Ours ours = runHere(text);
      std::string what;
      const Verdict verdict = compare(*theirs, ours.run, what);
      ++found[verdict];
      if (verdict == Verdict::kDifferent) {
        const std::string name = fmt::format("{}/different-{}-{}.ngc", folder, seed, k);
        std::ofstream(name) << text;
        fmt::print("{}: {}\n", name, what);
      }
      const bool again =
          verdict == Verdict::kSameRefusal && ours.line > 0 && ours.line <= static_cast<int>(lines.size());
      if (!again) break;
      lines.erase(lines.begin() + ours.line - 1);
    }
  }
  fmt::print("same {}, same refusal {}, different {}\n", found[Verdict::kSame], found[Verdict::kSameRefusal],
             found[Verdict::kDifferent]);
  return found[Verdict::kDifferent] == 0 ? 0 : 1;
}

}  // namespace
}  // namespace proveout::peer

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 200;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::string folder = argc > 3 ? argv[3] : "out/peer";
  if (!proveout::peer::hasInterpreter()) {
    fmt::print("rs274 (LinuxCNC) is not installed: nothing to compare with\n");
    return 0;
  }
  return proveout::peer::compareAll(count, seed, folder);
}

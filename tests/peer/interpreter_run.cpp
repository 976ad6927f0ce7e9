#include "tests/peer/interpreter_run.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/geometry/degrees.h"

namespace proveout::peer {
namespace {

constexpr double kInch = 25.4;  // unit of everything the module says
constexpr const char* kModule = "/usr/lib/python3/dist-packages/rs274/__init__.py";

std::vector<double> numbersOf(const std::string& text) {
  std::vector<double> all;
  const char* at = text.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) {
      ++at;
      continue;
    }
    all.push_back(value);
    at = end;
  }
  return all;
}

/// The canonical commands, which are said in work coordinates.
class Canon {
 public:
  void command(const std::string& name, const std::vector<double>& n) {
    if (name == "SELECT_PLANE" && !n.empty()) plane_ = n[0] == 2.0 ? 2 : n[0] == 3.0 ? 1 : 0;
    if (name == "SET_G5X_OFFSET" && n.size() > 3) frame_ = kInch * Vec3(n[1], n[2], n[3]);
    if (name == "SET_G92_OFFSET" && n.size() > 2) shift_ = kInch * Vec3(n[0], n[1], n[2]);
    if (name == "SET_XY_ROTATION" && !n.empty()) turn_ = degToRad(n[0]);
    if (name == "USE_TOOL_LENGTH_OFFSET" && n.size() > 2) length_ = kInch * Vec3(n[0], n[1], n[2]);
    const bool rapid = name == "STRAIGHT_TRAVERSE";
    const bool tap = name == "RIGID_TAP";
    const bool line = rapid || tap || name == "STRAIGHT_FEED" || name == "STRAIGHT_PROBE";
    const Vec3 before = at_;
    if (line && n.size() > 2) addLine(rapid ? 'R' : 'F', machine(kInch * Vec3(n[0], n[1], n[2])));
    if (tap) addLine('F', before);
    if (name == "ARC_FEED" && n.size() > 5) addArc(n);
  }
  PeerRun run;

 private:
  void addLine(char kind, const Vec3& to) { add({kind, to, Vec3::Zero(), Vec3::Zero(), 0}); }
  /// `n`: end and centre in the plane, turns (below 0: clockwise), end along the axis.
  void addArc(const std::vector<double>& n) {
    const int u = plane_ == 0 ? 0 : plane_ == 1 ? 2 : 1, v = (u + 1) % 3, w = (u + 2) % 3;
    Vec3 to, center = program(at_);
    to[u] = kInch * n[0];
    to[v] = kInch * n[1];
    to[w] = kInch * n[5];
    const Vec3 from = center;
    center[u] = kInch * n[2];
    center[v] = kInch * n[3];
    const auto angle = [&](const Vec3& p) { return std::atan2(p[v] - center[v], p[u] - center[u]); };
    const double sweep = sweepOf(angle(to) - angle(from), n[4]);
    const Vec3 axis = machine(Vec3::Unit(w)) - machine(Vec3::Zero());
    add({'A', machine(to), machine(center), sweep * axis, 0});
  }
  /// rad; the angle between the ends and the turns of the command make the sweep.
  static double sweepOf(double sweep, double turns) {
    constexpr double kTurn = 2.0 * M_PI, kNone = 1e-9;
    if (turns > 0.0) {
      while (sweep <= kNone) sweep += kTurn;
      return sweep + kTurn * (turns - 1.0);
    }
    while (sweep >= -kNone) sweep -= kTurn;
    return sweep + kTurn * (turns + 1.0);
  }
  void add(const PeerMotion& motion) {
    run.motions.push_back(motion);
    at_ = motion.to;
  }
  Vec3 program(Vec3 p) const {
    p -= frame_ + length_;
    const double c = std::cos(turn_), s = std::sin(turn_);
    return Vec3(c * p.x() + s * p.y(), -s * p.x() + c * p.y(), p.z()) - shift_;
  }
  Vec3 machine(Vec3 p) const {
    p += shift_;
    const double c = std::cos(turn_), s = std::sin(turn_);
    return Vec3(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()) + frame_ + length_;
  }
  double turn_ = 0.0;
  int plane_ = 0;
  Vec3 frame_ = Vec3::Zero(), shift_ = Vec3::Zero(), length_ = Vec3::Zero(), at_ = Vec3::Zero();
};

std::vector<PeerRun> runsOf(std::istream& said) {
  std::vector<Canon> runs;
  for (std::string line; std::getline(said, line);) {
    if (line.starts_with("PROGRAM ")) runs.emplace_back();
    if (runs.empty()) continue;
    const std::size_t open = line.find('(');
    if (line.starts_with("ERROR "))
      runs.back().run.error = line.substr(6);
    else if (open != std::string::npos)
      runs.back().command(line.substr(0, open), numbersOf(line.substr(open)));
  }
  std::vector<PeerRun> all;
  for (Canon& c : runs) all.push_back(std::move(c.run));
  return all;
}

}  // namespace

bool hasInterpreter() { return std::filesystem::exists(kModule); }

std::string tableOf(const std::vector<PeerTool>& tools) {
  std::string table;
  int pocket = 1;
  for (const PeerTool& t : tools)
    table += fmt::format("T{} P{} Z{:.17g} D{:.17g}\n", t.number, pocket++, t.z / kInch, t.diameter / kInch);
  return table;
}

std::vector<PeerRun> runInterpreter(const std::vector<std::string>& paths, const std::string& table,
                                    const std::string& folder) {
  const std::filesystem::path at(folder);
  std::filesystem::create_directories(at);
  std::ofstream(at / "tool.tbl") << table;
  {
    std::ofstream list(at / "programs.txt");
    for (const std::string& path : paths) list << path << '\n';
  }
  const std::string command =
      fmt::format("/usr/bin/python3 '{}' '{}' < '{}' > '{}'", PROVEOUT_PEER_SCRIPT,
                  (at / "tool.tbl").string(), (at / "programs.txt").string(), (at / "said.txt").string());
  std::vector<PeerRun> runs;
  if (std::system(command.c_str()) == 0) {
    std::ifstream said(at / "said.txt");
    runs = runsOf(said);
  }
  runs.resize(paths.size(), PeerRun{{}, "the interpreter did not run"});
  return runs;
}

}  // namespace proveout::peer

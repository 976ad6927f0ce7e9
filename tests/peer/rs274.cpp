#include "tests/peer/rs274.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/geometry/degrees.h"

namespace proveout::peer {
namespace {

/// T1: 50 mm, diameter 10; T2: 30 mm, diameter 6. The interpreter counts in inches without an INI file.
constexpr const char* kTools =
    "T1 P1 Z1.968503937007874 D0.393700787401575\nT2 P2 Z1.181102362204724 D0.236220472440945\n";

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

/// The canonical commands, which are said in work coordinates and the units of the program.
class Canon {
 public:
  void command(const std::string& name, const std::string& words) {
    if (name == "COMMENT" || name == "MESSAGE") return;
    if (name == "USE_LENGTH_UNITS") unit_ = words.find("INCH") != std::string::npos ? 25.4 : 1.0;
    if (name == "SELECT_PLANE") plane_ = words.ends_with("XZ") ? 1 : words.ends_with("YZ") ? 2 : 0;
    const std::vector<double> n = numbersOf(words);
    if (name == "SET_G5X_OFFSET" && n.size() > 3) frame_ = unit_ * Vec3(n[1], n[2], n[3]);
    if (name == "SET_G92_OFFSET" && n.size() > 2) shift_ = unit_ * Vec3(n[0], n[1], n[2]);
    if (name == "SET_XY_ROTATION" && !n.empty()) turn_ = degToRad(n[0]);
    if (name == "USE_TOOL_LENGTH_OFFSET" && n.size() > 2) length_ = unit_ * Vec3(n[0], n[1], n[2]);
    const bool rapid = name == "STRAIGHT_TRAVERSE";
    if ((rapid || name == "STRAIGHT_FEED") && n.size() > 2)
      add({rapid ? 'R' : 'F', machine(unit_ * Vec3(n[0], n[1], n[2])), Vec3::Zero(), {}});
    if (name == "ARC_FEED" && n.size() > 5) {
      const auto xyz = [&](double u, double v, double w) {
        return Vec3(unit_ * (plane_ == 0 ? Vec3(u, v, w) : plane_ == 1 ? Vec3(v, w, u) : Vec3(w, u, v)));
      };
      add({'A',
           machine(xyz(n[0], n[1], n[5])),
           machine(xyz(n[2], n[3], 0.0)),
           {plane_ != 2, plane_ != 1, plane_ != 0}});
    }
  }
  std::vector<PeerMotion> motions;

 private:
  void add(const PeerMotion& motion) { motions.push_back(motion); }
  Vec3 machine(Vec3 p) const {
    p += shift_;
    const double c = std::cos(turn_), s = std::sin(turn_);
    return Vec3(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()) + frame_ + length_;
  }
  double unit_ = 1.0, turn_ = 0.0;
  int plane_ = 0;
  Vec3 frame_ = Vec3::Zero(), shift_ = Vec3::Zero(), length_ = Vec3::Zero();
};

std::string textOf(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

}  // namespace

bool hasInterpreter() { return std::system("command -v rs274 >/dev/null 2>&1") == 0; }

std::optional<PeerRun> runInterpreter(const std::string& program, const std::string& folder) {
  const std::filesystem::path at(folder);
  std::filesystem::create_directories(at);
  std::ofstream(at / "tool.tbl") << kTools;
  std::ofstream(at / "program.ngc") << program;
  std::filesystem::remove(at / "kept.var");
  const std::string command =
      "cd '" + folder +
      "' && timeout 20 rs274 -t tool.tbl -v kept.var -g program.ngc >motions.txt 2>errors.txt";
  if (std::system(command.c_str()) == -1) return std::nullopt;
  PeerRun run;
  Canon canon;
  std::istringstream motions(textOf(at / "motions.txt"));
  for (std::string line; std::getline(motions, line);) {
    const std::size_t open = line.find('('), close = line.rfind(')');
    if (open == std::string::npos || close == std::string::npos || close < open) continue;
    const std::size_t begin = line.rfind(' ', open);
    if (begin == std::string::npos) continue;
    canon.command(line.substr(begin + 1, open - begin - 1), line.substr(open + 1, close - open - 1));
  }
  run.motions = std::move(canon.motions);
  std::istringstream errors(textOf(at / "errors.txt"));
  for (std::string line; run.error.empty() && std::getline(errors, line);) {
    const bool noise = line.find_first_not_of(' ') == std::string::npos || line == "executing" ||
                       line.find("variable file") != std::string::npos ||
                       line.find("percent sign") != std::string::npos;
    if (!noise) run.error = line;
  }
  return run;
}

}  // namespace proveout::peer

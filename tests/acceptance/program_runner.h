// Runs the built program in a folder of its own and catches what it says.
#pragma once

#include <stdlib.h>
#include <sys/wait.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace proveout::test {

struct Outcome {
  int exit_code = -1;  ///< 128 + signal if it was killed
  std::string out, err;
};

inline std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Workbench {
 public:
  Workbench() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / ("proveout-acceptance-" + std::string(6, 'X'))).string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~Workbench() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;

  std::string program = PROVEOUT_BINARY;  ///< that is run

  std::string path(const std::string& name = {}) const { return folder_ + "/" + name; }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << bytes;
    return name;
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Names in a folder below, sorted; empty where there is none.
  std::set<std::string> files(const std::string& name) const {
    std::set<std::string> found;
    if (!exists(name)) return found;
    for (const auto& entry : std::filesystem::directory_iterator(path(name))) {
      found.insert(entry.path().filename().string());
    }
    return found;
  }

  /// `arguments` as for a shell. `before` goes before the program. No run may hang.
  Outcome run(const std::string& arguments, const std::string& before = "timeout 100") const {
    Outcome outcome = runInto(".out", arguments, before);
    outcome.out = readFile(path(".out"));
    return outcome;
  }
  /// The same with stdout going to a file or device.
  Outcome runInto(const std::string& output, const std::string& arguments,
                  const std::string& before = "timeout 100") const {
    const std::string command =
        "cd '" + folder_ + "' && " + before + " '" + program + "' " + arguments + " >" + output + " 2>.err";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.err = readFile(path(".err"));
    return outcome;
  }

 private:
  std::string folder_;
};

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A square ring of 10 mm, 2 deep, for a tool of 4 mm in a blank of 20 x 20 x 10 with its top at 0.
inline constexpr const char* kRing =
    "G21 G90 G17 T1 M6\nS1000 M3\nG0 X5 Y5 Z5\nN40 G1 Z-2 F200\nX15\nY15\nX5\nY5\nG0 Z5\nM30\n";
inline constexpr const char* kRingOptions =
    " --control nct --stock box:0,0,-10:20,20,0 --tool 1=flat:4 --resolution 0.5 ";

/// Box as OBJ text, closed.
inline std::string boxObj(double x0, double y0, double z0, double x1, double y1, double z1) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    text += "v " + std::to_string((i & 1) ? x1 : x0) + " " + std::to_string((i & 2) ? y1 : y0) + " " +
            std::to_string((i & 4) ? z1 : z0) + "\n";
  }
  return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

}  // namespace proveout::test

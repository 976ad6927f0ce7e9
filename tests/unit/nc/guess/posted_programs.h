// The posted programs of tests/unit/nc/posted with what is known of them.
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace proveout::test {

inline std::string textOfFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A row of posted.tsv, which make_posted.py derives from closed forms.
struct PostedProgram {
  std::string file, control, flavour;           ///< flavour: empty for the default
  std::optional<std::array<double, 6>> extent;  ///< of feed motions: x0 y0 z0 x1 y1 z1, mm
  std::optional<double> length;                 ///< of feed motions, mm
  std::optional<double> end_z;                  ///< where the last motion ends
  std::string text() const { return textOfFile(folder() / file); }

  static std::filesystem::path folder() {
    return std::filesystem::path(PROVEOUT_SOURCE_DIR) / "tests/unit/nc/posted";
  }
};

/// Names of tests must not hold addresses.
inline void PrintTo(const PostedProgram& program, std::ostream* out) { *out << program.file; }

inline std::vector<PostedProgram> postedPrograms() {
  std::vector<PostedProgram> all;
  std::ifstream in(PostedProgram::folder() / "posted.tsv");
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    PostedProgram one;
    words >> one.file >> one.control >> one.flavour;
    if (one.flavour == "-") one.flavour.clear();
    const auto number = [&]() -> std::optional<double> {
      std::string word;
      words >> word;
      return word == "-" ? std::nullopt : std::optional(std::stod(word));
    };
    std::array<double, 6> extent{};
    bool told = true;
    for (double& side : extent) {
      const auto value = number();
      told = told && value.has_value();
      side = value.value_or(0.0);
    }
    if (told) one.extent = extent;
    one.length = number();
    one.end_z = number();
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace proveout::test

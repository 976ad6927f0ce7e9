// What is rounded to float stays rounded: see core/geometry/to_float.h. The sources that the compiler may
// make vectors of round by that alone.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "core/geometry/to_float.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;

/// Those of the targets in proveout_round_by_to_float (removal/CMakeLists.txt).
bool isVectorized(const std::string& file) {
  return (file.starts_with("core/") || file.starts_with("removal/")) &&
         !file.starts_with("removal/compare/") && !file.starts_with("removal/vdb/") &&
         file != "core/geometry/to_float.h";
}

/// Lines in which a value is converted to float: static_cast, Eigen's cast, and the old ways.
std::vector<std::string> castsToFloat(const fs::path& root, const std::string& file) {
  static const std::regex kCast(R"(cast\s*<\s*float\s*>|\bfloat\s*[({]|\(\s*float\s*\))");
  std::vector<std::string> found;
  std::ifstream in(root / file);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string code = line.substr(0, line.find("//"));
    if (std::regex_search(code, kCast)) found.push_back(file + ":" + std::to_string(number) + ": " + line);
  }
  return found;
}

TEST(Rounding, IsByToFloatWhereTheCompilerMayMakeVectors) {
  const fs::path root(PROVEOUT_SOURCE_DIR);
  std::size_t files = 0;
  for (const char* folder : {"core", "removal"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string file = fs::relative(entry.path(), root).generic_string();
      const std::string extension = entry.path().extension().string();
      if ((extension != ".h" && extension != ".cpp") || !isVectorized(file)) continue;
      ++files;
      for (const std::string& line : castsToFloat(root, file))
        ADD_FAILURE() << line << "\nround with toFloat of core/geometry/to_float.h";
    }
  }
  EXPECT_GT(files, 200u);
}

TEST(Rounding, KeepsSignsAndSpecialValues) {
  EXPECT_EQ(toFloat(0.1), 0.1f);
  EXPECT_EQ(toFloat(-1e300), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(toFloat(7), 7.0f);
  const Eigen::Vector3d p(0.1, -26.123456789, 1e-50);
  EXPECT_EQ(toFloat(p), Eigen::Vector3f(0.1f, -26.123456789f, 0.0f));
  static_assert(toFloat(0.5) == 0.5f);
}

}  // namespace
}  // namespace proveout

// The commands and sample outputs of the documents, run as a reader would.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <vector>

#include "program_runner.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

std::string document(const std::string& name) {
  return readFile(std::string(PROVEOUT_SOURCE_DIR) + "/" + name);
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos ? std::string()
                                    : line.substr(first, line.find_last_not_of(' ') - first + 1);
}

/// What follows the program's name in the indented lines that call it.
std::vector<std::string> commandsOf(const std::string& name) {
  std::vector<std::string> out;
  static const std::regex call("^ {4,}(?:build/release/bin/)?proveout (.*)$");
  for (const std::string& line : linesOf(document(name))) {
    std::smatch match;
    if (std::regex_match(line, match, call)) out.push_back(match[1]);
  }
  return out;
}

/// Files below a folder of the sources, as paths from the top.
std::vector<std::string> filesBelow(const std::string& folder) {
  const fs::path root(PROVEOUT_SOURCE_DIR);
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder))
    names.push_back(fs::relative(entry.path(), root).generic_string());
  return names;
}

/// The documents but the decisions, which tell of the sources of their time.
std::vector<std::string> documentsOfToday() {
  std::vector<std::string> names = filesBelow("docs");
  std::erase_if(names, [](const std::string& name) {
    return !name.ends_with(".md") || name.starts_with("docs/decisions/");
  });
  names.push_back("README.md");
  return names;
}

/// What the first group of `pattern` finds in a document.
std::vector<std::string> foundIn(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

/// A folder with what the documents speak of.
void furnish(const Workbench& bench) {
  bench.write("part.nc",
              "%\nO1\nG21 G90 G17 T1 M6\nS3000 M3\nG0 X10 Y10 Z5\nG1 Z-2 F300\nX60\nG0 Z50\nN120 M30\n%\n");
  bench.write(
      "job.toml",
      "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"part.nc\"\n[stock]\nshape = \"box\"\n"
      "min = [0, 0, -20]\nmax = [80, 60, 0]\n[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 10\n"
      "[[tool]]\nnumber = 2\ntype = \"drill\"\ndiameter = 5\n[simulation]\nresolution = 0.5\n");
  fs::create_directory_symlink(std::string(PROVEOUT_SOURCE_DIR) + "/parts", bench.path("parts"));
  const auto made = [&](const std::string& arguments, const std::string& file, const std::string& name) {
    ASSERT_EQ(bench.run(arguments).exit_code, 0);
    fs::copy_file(bench.path(file), bench.path(name), fs::copy_options::overwrite_existing);
  };
  made("run job.toml --no-render --out made", "made/job.stl", "part.stl");
  made("run job.toml --no-render --format ply --out scanned", "scanned/job.ply", "scan.ply");
  for (const char* name : {"machined.stl", "nominal.stl"})
    fs::copy_file(bench.path("part.stl"), bench.path(name));
  ASSERT_EQ(bench.run("run parts/gouged_plate/job.toml --no-render --out plate-out").exit_code, 1);
}

TEST(Documents, EveryCommandOfTheirsRuns) {
  const Workbench bench;
  ASSERT_NO_FATAL_FAILURE(furnish(bench));
  std::size_t count = 0;
  for (const std::string& name : documentsOfToday()) {
    if (name.starts_with("docs/design/")) continue;
    for (const std::string& command : commandsOf(name)) {
      ++count;
      const Outcome outcome = bench.run(command);
      EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
          << name << ": proveout " << command << "\n"
          << outcome.exit_code << " " << outcome.err;
    }
  }
  EXPECT_GE(count, 10u);
}

TEST(Documents, FilesThatTheyNameExist) {
  const fs::path root(PROVEOUT_SOURCE_DIR);
  std::vector<std::string> sources;
  for (const char* folder : {"core", "removal", "io", "render", "app", "tests"}) {
    for (const std::string& name : filesBelow(folder)) sources.push_back("/" + name);
  }
  for (const std::string& name : documentsOfToday()) {
    const std::string text = document(name);
    for (const std::string& path :
         foundIn(text, "`((?:core|removal|io|render|app|tests|parts)/[a-z0-9_./]+)`"))
      EXPECT_TRUE(fs::exists(root / path)) << name << ": " << path;
    for (const std::string& path : foundIn(text, "`([a-z0-9_./]+\\.(?:h|cpp))`")) {
      EXPECT_TRUE(std::any_of(sources.begin(), sources.end(),
                              [&](const std::string& source) { return source.ends_with("/" + path); }))
          << name << ": " << path;
    }
    for (const std::string& link : foundIn(text, "\\]\\(([^)#: ]+)"))
      EXPECT_TRUE(fs::exists((root / name).parent_path() / link)) << name << ": " << link;
  }
}

TEST(Documents, TheGougeThatTheyShowIsWhatTheProgramSays) {
  const Workbench bench;
  ASSERT_NO_FATAL_FAILURE(furnish(bench));
  std::vector<std::string> said;
  for (const std::string& line :
       linesOf(bench.run("run parts/gouged_plate/job.toml --no-render --out again").err))
    said.push_back(trimmed(line));
  for (const char* name : {"README.md", "docs/user-guide.md"}) {
    const std::vector<std::string> lines = linesOf(document(name));
    std::size_t shown = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].rfind("    plate.nc:40: error[gouge]", 0) != 0) continue;
      for (std::size_t k = i; k < lines.size() && lines[k].rfind("    ", 0) == 0; ++k) {
        ++shown;
        EXPECT_NE(std::find(said.begin(), said.end(), trimmed(lines[k])), said.end())
            << name << " shows a line that the program does not say: " << lines[k];
      }
    }
    EXPECT_GE(shown, 4u) << name;
  }
}

TEST(Explain, NamesBlockDeviationAndWords) {
  const Workbench bench;
  ASSERT_NO_FATAL_FAILURE(furnish(bench));
  const Outcome wrong = bench.run("explain plate-out --at 33,25.4,-6");
  EXPECT_EQ(wrong.exit_code, 0) << wrong.err;
  EXPECT_TRUE(has(wrong.out, "plate.nc:40 (N340)")) << wrong.out;
  EXPECT_TRUE(has(wrong.out, "mm below nominal")) << wrong.out;
  EXPECT_TRUE(has(wrong.out, "cause ")) << wrong.out;
  EXPECT_TRUE(has(wrong.out, "with Z-6. nothing of it is left")) << wrong.out;
  EXPECT_TRUE(has(wrong.out, "Z Z-6.35")) << wrong.out;
  EXPECT_EQ(bench.run("explain plate-out --at 33,25.4").exit_code, 2);
  EXPECT_EQ(bench.run("explain plate-out --at 500,0,0").exit_code, 2);
  EXPECT_EQ(bench.run("explain nowhere --at 1,2,3").exit_code, 2);
  // A job without a nominal: who made it, and what was in force.
  ASSERT_EQ(bench.run("run job.toml --no-render --out plain").exit_code, 0);
  const Outcome plain = bench.run("explain plain/report.json --at 30,10,-2");
  EXPECT_EQ(plain.exit_code, 0) << plain.err;
  EXPECT_TRUE(has(plain.out, "part.nc:7")) << plain.out;
  EXPECT_TRUE(has(plain.out, "Z Z-2 (part.nc:6)")) << plain.out;
  // Another program than the report's is refused.
  bench.write("part.nc", "G0 X1\nM30\n");
  const Outcome changed = bench.run("explain plain --at 30,10,-2");
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_TRUE(has(changed.err, "run it again")) << changed.err;
}

}  // namespace
}  // namespace proveout::test

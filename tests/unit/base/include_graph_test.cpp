// Who includes whom: no header includes itself by a detour, no folder one that stands above it, and no large
// knot of rooms (a source with its header) that need each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace proveout {
namespace {

namespace fs = std::filesystem;

using Graph = std::map<std::string, std::set<std::string>>;

const std::vector<std::string> kFolders = {"core", "removal", "io", "render", "app"};
/// From the lowest. The run as a library knows neither pictures nor the program around it.
const std::vector<std::string> kFloors = {"core/base",
                                          "core/geometry",
                                          "core/mesh",
                                          "core/machine",
                                          "core/path",
                                          "core/tool",
                                          "core/nc/control",
                                          "core/nc/limits",
                                          "core/nc",
                                          "core/nc/registry",
                                          "removal/grid",
                                          "removal/sweep",
                                          "removal/cut",
                                          "removal/surface/cell",
                                          "removal/surface/mesh",
                                          "removal/surface/measure",
                                          "removal/surface/repair",
                                          "removal/surface",
                                          "removal/contact",
                                          "removal/turning/section",
                                          "removal/turning/threads",
                                          "removal/turning",
                                          "removal/wire/section",
                                          "removal/wire/lean",
                                          "removal/wire/falls",
                                          "removal/wire/contact",
                                          "removal/wire",
                                          "removal/vdb",
                                          "removal/compare",
                                          "removal/exact",
                                          "removal/process",
                                          "io",
                                          "io/job",
                                          "io/report/view",
                                          "io/report",
                                          "app/session/nominal",
                                          "app/session/forecast",
                                          "app/session/run",
                                          "app/session/programs",
                                          "app/session/findings",
                                          "app/session/program_checks",
                                          "app/session/process",
                                          "app/session/machining",
                                          "app/session/causes",
                                          "app/session",
                                          "render",
                                          "app/page",
                                          "app"};
/// Rooms of the largest knot: the checks of a program.
constexpr std::size_t kLargestKnot = 5;
/// Folders of the largest: context, model and stages of core/nc/iso.
constexpr std::size_t kLargestFolderKnot = 3;
constexpr std::size_t kMostFiles = 45;

/// The files of the product with the files of it that they include.
const Graph& includes() {
  static const Graph kGraph = [] {
    Graph graph;
    const fs::path root(PROVEOUT_SOURCE_DIR);
    for (const std::string& folder : kFolders) {
      for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".h" || extension == ".cpp")
          graph[fs::relative(entry.path(), root).generic_string()];
      }
    }
    for (auto& [file, included] : graph) {
      std::ifstream in(root / file);
      for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("#include \"")) continue;
        const std::string name = line.substr(10, line.find('"', 10) - 10);
        if (graph.contains(name)) included.insert(name);
      }
    }
    return graph;
  }();
  return kGraph;
}

/// Strongly connected parts of more than one node, the largest first (R. Tarjan, 1972).
std::vector<std::vector<std::string>> knots(const Graph& graph) {
  std::map<std::string, std::size_t> number, low;
  std::vector<std::string> open;
  std::set<std::string> is_open;
  std::vector<std::vector<std::string>> out;
  const std::function<void(const std::string&)> visit = [&](const std::string& at) {
    number[at] = low[at] = number.size();
    open.push_back(at);
    is_open.insert(at);
    for (const std::string& next : graph.at(at)) {
      if (!number.contains(next)) visit(next);
      if (is_open.contains(next)) low[at] = std::min(low[at], low[next]);
    }
    if (low[at] != number[at]) return;
    std::vector<std::string> knot;
    do {
      knot.push_back(open.back());
      is_open.erase(open.back());
      open.pop_back();
    } while (knot.back() != at);
    std::sort(knot.begin(), knot.end());
    if (knot.size() > 1) out.push_back(std::move(knot));
  };
  for (const auto& [node, next] : graph) {
    if (!number.contains(node)) visit(node);
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return out;
}

std::string text(const std::vector<std::string>& knot) {
  std::ostringstream out;
  for (const std::string& node : knot) out << "\n  " << node;
  return out.str();
}

std::string folderOf(const std::string& file) { return file.substr(0, file.rfind('/')); }
std::string roomOf(const std::string& file) { return file.substr(0, file.rfind('.')); }

TEST(IncludeGraph, NoHeaderIncludesItself) {
  Graph headers;
  for (const auto& [file, included] : includes()) {
    if (!file.ends_with(".h")) continue;
    headers[file] = included;
  }
  ASSERT_GT(headers.size(), 100u);
  for (const auto& knot : knots(headers)) ADD_FAILURE() << "headers that include each other:" << text(knot);
}

TEST(IncludeGraph, FoldersIncludeWhatIsBelow) {
  const auto floorOf = [](const std::string& file) {
    std::size_t floor = 0, longest = 0;
    for (std::size_t i = 0; i < kFloors.size(); ++i) {
      if (!file.starts_with(kFloors[i] + "/") || kFloors[i].size() < longest) continue;
      floor = i;
      longest = kFloors[i].size();
    }
    return floor;
  };
  for (const auto& [file, included] : includes()) {
    if (file.starts_with("core/") || file.starts_with("removal/")) {
      EXPECT_GT(std::count(file.begin(), file.end(), '/'), 1) << file << " stands in no room";
    }
    for (const std::string& other : included)
      EXPECT_LE(floorOf(other), floorOf(file)) << file << ": " << other;
  }
}

/// The run loop stands between the limits of a run and the controls.
TEST(IncludeGraph, TheRunLoopKnowsNoControl) {
  const std::vector<std::string> below = {"core/base/", "core/nc/control/", "core/nc/limits/",
                                          "core/nc/text/", "core/nc/flow/"};
  std::size_t files = 0;
  for (const auto& [file, included] : includes()) {
    if (!file.starts_with("core/nc/flow/")) continue;
    ++files;
    for (const std::string& other : included) {
      const auto isIn = [&](const std::string& folder) { return other.starts_with(folder); };
      EXPECT_TRUE(std::any_of(below.begin(), below.end(), isIn)) << file << ": " << other;
    }
  }
  EXPECT_GT(files, 2u);
}

TEST(IncludeGraph, KnotsOfRoomsAreSmall) {
  Graph rooms;
  for (const auto& [file, included] : includes()) {
    auto& others = rooms[roomOf(file)];
    for (const std::string& other : included) {
      if (roomOf(other) != roomOf(file)) others.insert(roomOf(other));
    }
  }
  const auto found = knots(rooms);
  ASSERT_FALSE(found.empty());
  EXPECT_LE(found.front().size(), kLargestKnot) << text(found.front());
  EXPECT_GE(found.front().size() + 2, kLargestKnot) << "the limit may be lower now";
}

TEST(IncludeGraph, KnotsOfFoldersAreSmall) {
  Graph folders;
  for (const auto& [file, included] : includes()) {
    auto& others = folders[folderOf(file)];
    for (const std::string& other : included) {
      if (folderOf(other) != folderOf(file)) others.insert(folderOf(other));
    }
  }
  const auto found = knots(folders);
  ASSERT_FALSE(found.empty());
  EXPECT_LE(found.front().size(), kLargestFolderKnot) << text(found.front());
  EXPECT_GE(found.front().size() + 2, kLargestFolderKnot) << "the limit may be lower now";
  EXPECT_TRUE(found.size() < 2 || found[1].size() <= 3) << text(found[1]);
}

TEST(IncludeGraph, FoldersAreNoCorridors) {
  std::map<std::string, std::size_t> files;
  for (const auto& [file, included] : includes()) ++files[folderOf(file)];
  for (const auto& [folder, count] : files) EXPECT_LE(count, kMostFiles) << folder;
}

std::string contentOf(const std::string& file) {
  std::ifstream in(fs::path(PROVEOUT_SOURCE_DIR) / file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What all controls of the ISO family do knows none of them: they hand in tables.
TEST(IsoWall, TheSharedCodeNamesNoControl) {
  std::size_t seen = 0;
  for (const auto& [file, included] : includes()) {
    if (!file.starts_with("core/nc/iso/")) continue;
    ++seen;
    for (const std::string& other : included) {
      for (const char* control : {"nct/", "fanuc/", "linuxcnc/", "wl4/", "flexnc/", "wedm/", "registry/"})
        EXPECT_FALSE(other.starts_with(std::string("core/nc/") + control)) << file << ": " << other;
    }
    const std::string all = contentOf(file);
    for (const char* name : {"\"nct", "ControlId"})
      EXPECT_EQ(all.find(name), std::string::npos) << file << ": " << name;
  }
  EXPECT_GT(seen, 100u);
}

/// Controls of the family are tables beside each other: what two of them need is the family's.
TEST(IsoWall, ControlsOfTheFamilyKnowNoOther) {
  const std::vector<std::string> family{"core/nc/nct/", "core/nc/fanuc/", "core/nc/linuxcnc/"};
  for (const auto& [file, included] : includes()) {
    for (const std::string& own : family) {
      if (!file.starts_with(own)) continue;
      for (const std::string& other : included) {
        for (const std::string& control : family)
          EXPECT_FALSE(control != own && other.starts_with(control)) << file << ": " << other;
      }
    }
  }
}

/// What a process is shows in its row and in its workpieces alone: with another one nothing else changes.
TEST(ProcessWall, NobodyElseAsksWhichProcessItIs) {
  for (const auto& [file, included] : includes()) {
    if (!file.starts_with("app/") || file.starts_with("app/session/process/") ||
        file.starts_with("app/session/run/process."))
      continue;
    const std::string all = contentOf(file);
    for (const char* name : {"ProcessKind", "TurnedShape", "TurnedForm", "TurnedPiece", "TurnedStock",
                             "WireStock", "WirePiece", "MilledPiece"})
      EXPECT_EQ(all.find(name), std::string::npos) << file << ": " << name;
  }
}

/// What kind a swept body is shows in removal/sweep alone: with another kind nothing else changes.
TEST(BodyWall, NobodyElseAsksWhatKindABodyIs) {
  std::size_t kinds = 0;
  for (const auto& [file, included] : includes()) {
    const std::string all = contentOf(file);
    const bool within = file.starts_with("removal/sweep/");
    for (const char* name :
         {"LineBody",   "ChordBody",  "LevelArcBody", "TurnBody",       "UprightBody",   "WayBody",
          "BodyKind",   "LineSweep",  "ArcSweep",     "TurnSweep",      "UprightSweep",  "WaySweep",
          "columnLine", "columnArc",  "columnTurns",  "columnUprights", "columnParts",   "CurveWay",
          "kernelsOf",  "round_top",  "LeanLine",     "LeanArc",        "LeanChordBody", "LineMeeting",
          "PosedBody",  "PosedPiece", "PosedTrack",   "PoseRunBody",    "PosePiece"}) {
      const bool named = all.find(name) != std::string::npos;
      if (within) kinds += named ? 1 : 0;
      EXPECT_TRUE(within || !named) << file << ": " << name;
    }
  }
  EXPECT_GT(kinds, 20u) << "the kinds have other names now";
}

}  // namespace
}  // namespace proveout

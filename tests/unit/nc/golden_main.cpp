// One test a golden file, and what the set of files must cover.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "core/nc/nct/alarms.h"
#include "core/nc/registry/coverage.h"
#include "core/path/origin_query.h"
#include "golden_case.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> goldenFiles() {
  std::vector<std::string> files;
  const fs::path root = fs::path(PROVEOUT_SOURCE_DIR) / "tests/unit/nc/golden";
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() == ".nc") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class GoldenTest : public testing::Test {
 public:
  explicit GoldenTest(std::string path) : path_(std::move(path)) {}
  void TestBody() override {
    const GoldenCase golden = readGolden(path_);
    std::vector<GoldenMotion> motions;
    const std::string text = runGolden(golden, motions);
    EXPECT_EQ(compareWithTruth(golden.truth, motions), "") << text;
    EXPECT_EQ(missingIn(text, golden.says), "") << text;
    const bool bad = fs::path(path_).parent_path().filename() == "bad";
    EXPECT_EQ(text.find("error[") != std::string::npos, bad) << text;
    if (std::getenv("PROVEOUT_UPDATE_GOLDEN") != nullptr) {
      writeGolden(golden, text);
    } else {
      EXPECT_EQ(text, golden.expect);
    }
  }

 private:
  std::string path_;
};

/// The controls whose tables are checked, and how their ids begin.
struct Control {
  ControlId id = ControlId::kNct;
  const char* prefix = "";
  std::size_t rows = 0;       ///< of the control's own list
  std::size_t specified = 0;  ///< of the manual
};
const Control kControls[] = {
    {ControlId::kNct, "nct-", 811, 844},       {ControlId::kWl4Lathe, "wl4-", 202, 202},
    {ControlId::kFlexNc, "fnc-", 163, 163},    {ControlId::kWedm, "wedm-", 95, 95},
    {ControlId::kFanucMill, "fan-", 324, 324}, {ControlId::kLinuxCnc, "lcn-", 142, 142}};

/// Ids of a control after "proves:" in the about sections.
std::set<std::string> provenIds(const Control& control) {
  std::set<std::string> ids;
  for (const std::string& path : goldenFiles()) {
    std::istringstream about(readGolden(path).about);
    bool listing = false;
    for (std::string word; about >> word;) {
      if (word == "proves:") {
        listing = true;
      } else if (listing && word.starts_with(control.prefix)) {
        ids.insert(word);
      }
    }
  }
  return ids;
}

/// Ids that a golden program names behind "proves:".
std::set<std::string> idsOf(const std::string& about) {
  std::set<std::string> ids;
  std::istringstream in(about);
  bool listing = false;
  for (std::string word; in >> word;) {
    if (listing) ids.insert(word);
    listing = listing || word == "proves:";
  }
  return ids;
}

class GoldenSet : public testing::TestWithParam<Control> {
 protected:
  const std::vector<CoverageIdRow> rows_ = coverageIds(GetParam().id).value();
  const std::vector<CoverageRow> table_ = coverageTable(GetParam().id).value();
};

TEST_P(GoldenSet, ProvesOnlyIdsOfTheRows) {
  std::set<std::string> known;
  for (const CoverageIdRow& row : rows_) known.insert(std::string(row.id));
  for (const std::string& id : provenIds(GetParam())) EXPECT_TRUE(known.count(id)) << id;
}

TEST_P(GoldenSet, EveryProofIsThereAndNamesItsRow) {
  const fs::path root(PROVEOUT_SOURCE_DIR);
  for (const CoverageIdRow& row : rows_) {
    if (row.proof.empty()) continue;
    const std::string id(row.id), proof(row.proof);
    if (proof.ends_with(".nc")) {
      const fs::path file = root / "tests/unit/nc/golden" / proof;
      ASSERT_TRUE(fs::exists(file)) << id << " " << proof;
      EXPECT_TRUE(idsOf(readGolden(file.string()).about).contains(id)) << id << " " << proof;
    } else {
      std::ifstream in(root / proof);
      std::ostringstream text;
      text << in.rdbuf();
      EXPECT_NE(text.str().find(id), std::string::npos) << id << " " << proof;
    }
  }
}

TEST_P(GoldenSet, RowsKnowTheCodeTablesAndTheProofs) {
  std::map<std::string, std::string> status;
  for (const CoverageIdRow& row : rows_) {
    EXPECT_TRUE(status.emplace(row.id, row.status).second) << row.id << " twice";
  }
  EXPECT_EQ(status.size(), GetParam().rows);
  for (const CoverageRow& row : table_) {
    std::istringstream ids(row.ids);
    for (std::string id; ids >> id;) EXPECT_TRUE(status.contains(id)) << row.code << ": " << id;
  }
  for (const std::string& id : provenIds(GetParam())) EXPECT_NE(status[id], "missing") << id << " is proven";
}

TEST_P(GoldenSet, EveryRowOfTheSpecificationIsProvenOrListedOpen) {
  std::map<std::string, SpecificationRow> asked;
  for (const SpecificationRow& row : specificationRows(GetParam().id)) {
    EXPECT_TRUE(asked.emplace(row.id, row).second) << row.id << " twice";
    EXPECT_NE(row.status, "unlisted") << row.id;
    if (row.status == "open") {
      EXPECT_FALSE(row.reason.empty()) << row.id;
    }
  }
  EXPECT_EQ(asked.size(), GetParam().specified);
  for (const CoverageIdRow& row : rows_) {
    ASSERT_TRUE(asked.contains(std::string(row.id))) << row.id;
    EXPECT_EQ(asked[std::string(row.id)].cls, row.cls) << row.id;
  }
  // A code of another class than the row that it serves needs a reason.
  std::map<std::string, std::string> classes;
  for (const CoverageRow& code : table_) {
    std::istringstream ids(code.ids);
    for (std::string id; ids >> id;) classes.emplace(id, code.cls);
  }
  for (const auto& [id, cls] : classes) {
    EXPECT_TRUE(cls == asked[id].cls || !asked[id].reason.empty()) << id;
  }
}

TEST(GoldenFiles, EachHasATruthOrIsNamedCharacterisation) {
  std::map<GoldenProof, std::vector<std::string>> files;
  for (const std::string& path : goldenFiles()) files[proofOf(readGolden(path))].push_back(path);
  for (const std::string& path : files[GoldenProof::kNone])
    ADD_FAILURE() << path << ": give it a truth or a says from the manual or by hand, or name it "
                  << "characterisation and say why it has none";
  const std::vector<std::string>& bare = files[GoldenProof::kCharacterisation];
  fmt::print("goldens: {} with the motions known independently, {} with words, {} characterisation\n",
             files[GoldenProof::kTruth].size(), files[GoldenProof::kSays].size(), bare.size());
  for (const std::string& path : bare)
    fmt::print("characterisation: {}: {}\n", fs::path(path).filename().string(),
               readGolden(path).characterisation);
  RecordProperty("characterisation", static_cast<int>(bare.size()));
}

TEST(GoldenFiles, AGoldenWithoutAnIndependentValueIsFound) {
  GoldenCase golden;
  golden.about = "Says much, proves nothing.";
  golden.expect = "1: feed to 1 2 3\n";
  EXPECT_EQ(proofOf(golden), GoldenProof::kNone);
  golden.truth = golden.says = golden.characterisation = " \n\n";
  EXPECT_EQ(proofOf(golden), GoldenProof::kNone);
  golden.says = "error[nct-2055]\n";
  EXPECT_EQ(proofOf(golden), GoldenProof::kSays);
  golden.truth = "feed 1 2 3\n";
  EXPECT_EQ(proofOf(golden), GoldenProof::kTruth);
  golden.characterisation = "the manual does not tell where it stops\n";
  EXPECT_EQ(proofOf(golden), GoldenProof::kCharacterisation);
}

/// A cut of a wire: the lower track a quarter circle about the origin, the upper a line.
GoldenMotion quarterBelowALine() {
  GoldenMotion m;
  m.motion.kind = MotionKind::kFeed;
  m.motion.to = Vec3(0, 10, 0);
  m.wire.emplace();
  m.wire->z_high = 20.0;
  m.wire->lower = {Vec2(10, 0), Vec2(0, 10), Vec2(0, 0), degToRad(90.0)};
  m.wire->upper = {Vec2(10, 0), Vec2(0, 0), Vec2(0, 0), 0.0};
  return m;
}

TEST(GoldenFiles, TruthOfAWireIsComparedTrackByTrack) {
  const std::vector<GoldenMotion> cut{quarterBelowALine()};
  const auto wrong = [&](const std::string& truth) { return !compareWithTruth(truth, cut).empty(); };
  const std::string right =
      "feed 0 10 0 center 0 0 sweep 90 at 0.5 7.0711 7.0711 0 upper 0 0 20 at 0.5 5 0 20\n";
  EXPECT_EQ(compareWithTruth(right + "length 15.70796 10\n", cut), "");
  EXPECT_TRUE(wrong("feed 0 10 0 center 0 0 sweep 90\n"));               // nothing of the upper track
  EXPECT_TRUE(wrong("feed 0 10 0 upper 0 0 20\n"));                      // the lower one is no line
  EXPECT_TRUE(wrong("feed 0 10 0 sweep -90 upper 0 0 20\n"));            // it turns the other way
  EXPECT_TRUE(wrong("feed 0 10 0 center 0 1 sweep 90 upper 0 0 20\n"));  // about another centre
  EXPECT_TRUE(wrong("feed 0 10 0 sweep 90 upper 0 0 30\n"));             // another height
  EXPECT_TRUE(wrong("feed 0 10 0 sweep 90 upper 0 0 20 sweep 90\n"));    // the upper one is no arc
  EXPECT_TRUE(wrong(right + "length 15.709 10\n"));
  EXPECT_TRUE(wrong(right + "length 15.70796 10.1\n"));
  EXPECT_TRUE(wrong("length 15.70796 10\n"));  // the motion itself is not told
}

TEST(GoldenFiles, TruthOfLinesIsOfTheirEnds) {
  std::vector<GoldenMotion> motions(3);
  motions[0].motion.source.line = motions[1].motion.source.line = 4;
  motions[1].motion.to = Vec3(1, 2, 3);
  motions[1].axis.to = Vec3(0.6, 0, 0.8);
  motions[2].motion.source.line = 5;
  const auto wrong = [&](const std::string& truth) { return !compareWithTruth(truth, motions).empty(); };
  EXPECT_EQ(compareWithTruth("line 4 1 2 3 axis 0.6 0 0.8\nline 5 0 0 0\n", motions), "");
  EXPECT_TRUE(wrong("line 4 0 0 0\nline 5 0 0 0\n"));                // the first motion of the line
  EXPECT_TRUE(wrong("line 4 1 2 3 axis 0 0 1\nline 5 0 0 0\n"));     // another direction
  EXPECT_TRUE(wrong("line 4 1 2 3\n"));                              // line 5 is left out
  EXPECT_TRUE(wrong("line 4 1 2 3\nline 5 0 0 0\nline 6 0 0 0\n"));  // line 6 does not move
}

TEST(GoldenFiles, OneChannelAloneGivesThePathOfAProgramAlone) {
  int programs = 0;
  for (const std::string& path : goldenFiles()) {
    const GoldenCase golden = readGolden(path);
    // Alone, the channel's number is known and waiting codes have to name it.
    if (!golden.channels.empty() || golden.settings_text.find("N2201") != std::string::npos ||
        golden.settings_text.find("control = w") != std::string::npos ||
        golden.settings_text.find("control = flexnc") != std::string::npos)  // these have no channels
      continue;
    std::vector<GoldenMotion> motions;
    EXPECT_EQ(runGolden(golden, motions, true), golden.expect) << path;
    ++programs;
  }
  EXPECT_GT(programs, 400);
}

/// What a word of a kind may start with, where it is not the name of an axis; empty: anything.
std::string_view lettersOf(OriginKind kind) {
  switch (kind) {
    case OriginKind::kX:
      return "XUA";
    case OriginKind::kY:
      return "YVARQ";
    case OriginKind::kZ:
      return "ZWARQY";
    case OriginKind::kCyclePlane:
      return "R#";
    case OriginKind::kTool:
    case OriginKind::kNextTool:
      return "T";
    case OriginKind::kLengthOffset:
      return "H";
    case OriginKind::kRadiusOffset:
      return "D";
    case OriginKind::kFeed:
      return "F";
    case OriginKind::kMotionCode:
    case OriginKind::kPlane:
    case OriginKind::kDistance:
    case OriginKind::kUnits:
    case OriginKind::kCompensation:
    case OriginKind::kLengthCode:
    case OriginKind::kWorkOffset:
    case OriginKind::kCycle:
      return "G";
    case OriginKind::kVariable:
      return "#P";
    default:
      return {};
  }
}

/// What is wrong with an origin; empty: nothing.
std::string wrongWith(const ResolvedOrigin& origin, const GoldenPath& golden) {
  const std::string line = golden.line(origin.file, origin.line);
  const bool known = golden.texts.contains(golden.path.files[origin.file]);
  const std::string what = fmt::format("{} at {}:{} \"{}\"", originKindName(origin.kind),
                                       golden.path.files[origin.file], origin.line, origin.text);
  if (known && (origin.begin < 1 || origin.end > line.size() + 1 || origin.text.empty()))
    return what + " is not in: " + line;
  const std::string_view letters = lettersOf(origin.kind);
  if (known && !letters.empty() &&
      letters.find(static_cast<char>(std::toupper(origin.text[0]))) == std::string_view::npos)
    return what + " has another letter";
  for (const ResolvedOrigin& from : origin.from) {
    if (std::string wrong = wrongWith(from, golden); !wrong.empty()) return wrong;
  }
  return {};
}

TEST(GoldenFiles, EveryOriginStandsInItsText) {
  std::size_t origins = 0;
  for (const std::string& path : goldenFiles()) {
    const GoldenPath golden = pathOfGolden(readGolden(path));
    const LineText text = [&](std::uint32_t file, std::uint32_t line) { return golden.line(file, line); };
    const auto many = static_cast<MotionId>(golden.path.motions.size());
    for (MotionId m = 0; m < many; m += 1 + m / 100) {
      for (const ResolvedOrigin& origin : originsOf(golden.path, m, text)) {
        EXPECT_EQ(wrongWith(origin, golden), "") << path << " motion " << m;
        ++origins;
      }
      ASSERT_NE(dataOf(golden.path, m), nullptr) << path;
      EXPECT_EQ(dataOf(golden.path, m)->tool, golden.path.motions[m].tool) << path << " motion " << m;
    }
  }
  EXPECT_GT(origins, 30'000u);
}

/// Does a message begin with a text that may have a subject where `{}` stands?
bool beginsWith(const std::string& message, const std::string& text) {
  const std::size_t mark = text.find("{}");
  if (mark == std::string::npos) return message.starts_with(text);
  return message.starts_with(text.substr(0, mark)) &&
         message.find(text.substr(mark + 2), mark) != std::string::npos;
}

/// Does a message begin with a text of the manual's alarm of that number?
bool saysAlarm(int number, const std::string& message) {
  const nc::AlarmTable& alarms = nc::nctAlarms();
  for (std::size_t k = 0; k < nc::kSharedAlarms; ++k) {
    const auto alarm = static_cast<nc::SharedAlarm>(k);
    if (alarms.number(alarm) != number) continue;
    if (beginsWith(message, alarms.message(alarm, "{}"))) return true;
    if (message.starts_with(alarms.message(alarm, ""))) return true;
  }
  return false;
}

TEST(GoldenFiles, AlarmsBeginWithTheTextOfTheManual) {
  constexpr int kOfPrograms = 4000;  // #3000 adds it: the program has a text of its own
  int checked = 0;
  for (const std::string& path : goldenFiles()) {
    std::istringstream lines(readGolden(path).expect);
    for (std::string line; std::getline(lines, line);) {
      constexpr std::string_view kMark = "error[nct-";
      const std::size_t at = line.find(kMark);
      if (at == std::string::npos || std::isdigit(static_cast<unsigned char>(line[at + kMark.size()])) == 0)
        continue;
      const int number = std::stoi(line.substr(at + kMark.size()));
      if (number >= kOfPrograms) continue;
      ++checked;
      EXPECT_TRUE(saysAlarm(number, line.substr(line.find("]: ", at) + 3))) << path << "\n" << line;
    }
  }
  EXPECT_GT(checked, 100);
}

/// A golden file, or a test source where a machine with heads is needed.
TEST_P(GoldenSet, EverySimulatedCodeIsProven) {
  std::set<std::string> proven = provenIds(GetParam());
  for (const CoverageIdRow& row : rows_) {
    if (row.proof.starts_with("tests/")) proven.insert(std::string(row.id));
  }
  for (const CoverageRow& row : table_) {
    if (row.status != "simulated") continue;
    std::istringstream ids(row.ids);
    bool any = false;
    for (std::string id; ids >> id;) any = any || proven.count(id) > 0;
    EXPECT_TRUE(any) << row.code << ": " << row.ids;
  }
}

INSTANTIATE_TEST_SUITE_P(Controls, GoldenSet, testing::ValuesIn(kControls), [](const auto& test) {
  const std::string prefix = test.param.prefix;
  return prefix.substr(0, prefix.size() - 1);
});

}  // namespace
}  // namespace proveout::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  for (const std::string& path : proveout::test::goldenFiles()) {
    const std::filesystem::path file(path);
    const std::string folder = file.parent_path().filename().string();
    testing::RegisterTest(("Golden_" + folder).c_str(), file.stem().string().c_str(), nullptr, nullptr,
                          __FILE__, __LINE__,
                          [path]() -> testing::Test* { return new proveout::test::GoldenTest(path); });
  }
  return RUN_ALL_TESTS();
}

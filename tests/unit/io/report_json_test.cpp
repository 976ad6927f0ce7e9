#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/nc/registry/interpreter.h"
#include "report_sample.h"

namespace proveout {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Keeps what an interpreter says.
struct DiagnosticSink final : MotionSink {
  void file(std::uint32_t, const std::string&) override {}
  void motion(const Motion&, const ArcGeometry*, const AxisSweep*) override {}
  void event(const PathEvent&) override {}
  void diagnostic(const Diagnostic& diagnostic) override { all.push_back(diagnostic); }
  std::vector<Diagnostic> all;
};

TEST(ReportJson, AlarmsTellNumberPlaceCallsAndValues) {
  MemoryProgramSource source("main.nc", "G0 X1\nG65 P11 A7 B[2*3]\nM30\n");
  source.add("O0011", "N5 M98 P12\nM99\n");
  source.add("O0012", "G1 F100\nN20 G2 X8 Y#2 I[#1-5]\nM99\n");
  DiagnosticSink sink;
  interpret(ControlId::kNct, source, ControlSettings(), sink);
  Report report = io_test::sampleReport();
  report.diagnostics = sink.all;
  const Json j = Json::parse(reportJson(report))["diagnostics"];
  ASSERT_EQ(j.size(), 1u);
  EXPECT_EQ(j[0]["severity"], "error");
  EXPECT_EQ(j[0]["code"], "nct-2012");
  EXPECT_THAT(j[0]["message"].get<std::string>(), ::testing::StartsWith("circle radius difference error"));
  EXPECT_EQ(j[0]["source"], Json::parse(R"({"file": "O0012", "line": 2, "column": 1, "column_end": 22,
                                           "text": "N20 G2 X8 Y#2 I[#1-5]"})"));
  EXPECT_EQ(j[0]["notes"],
            Json({"called from O0011:1 by M98", "called from main.nc:2 by G65 #1=7 #2=6 #10=65 #16=11",
                  "Y#2 = 6", "I[#1-5] = 2"}));
}

TEST(ReportJson, HoldsWhatTheReportHolds) {
  const Json j = Json::parse(reportJson(io_test::sampleReport()));
  EXPECT_EQ(j["schema"], "proveout.report/1");
  EXPECT_EQ(j["verdict"], "fail");
  EXPECT_EQ(j["program"]["files"], Json({"bracket.nc", "O0100.nc"}));
  EXPECT_EQ(j["program"]["motions"], 15159);
  EXPECT_EQ(j["time"]["cycle_s"], 431.24);
  EXPECT_EQ(j["time"]["per_tool"][0]["removed_mm3"], 39730.12);
  EXPECT_EQ(j["accounting"]["total"]["removed_mm3"], 45622.82);
  EXPECT_EQ(j["accounting"]["total"]["time_s"], 431.24);
  EXPECT_EQ(j["accounting"]["per_tool"][0]["tool"], 1);
  EXPECT_EQ(j["accounting"]["per_tool"][0]["engagement_mm2"], 39730.12 / 4000);
  EXPECT_TRUE(j["accounting"]["per_tool"][1]["rate_mm3_min"].is_null());
  EXPECT_EQ(j["stock"]["mesh_mm3"], 82377.91);
  EXPECT_EQ(j["stock"]["bodies"][0]["role"], "part");
  EXPECT_EQ(j["stock"]["bodies"][0]["bounds"]["min"]["z"], -20);
  EXPECT_EQ(j["resolution_mm"], 0.25);
  const Json& gouge = j["findings"][0];
  EXPECT_EQ(gouge["kind"], "gouge");
  EXPECT_EQ(gouge["severity"], "error");
  EXPECT_EQ(gouge["where"]["x"], 20.125);
  EXPECT_EQ(gouge["depth_mm"], 0.25);
  EXPECT_EQ(gouge["source"]["file"], "O0100.nc");
  EXPECT_EQ(gouge["source"]["line"], 12);
  EXPECT_EQ(gouge["source"]["block"], "N70");
  EXPECT_EQ(gouge["tool"], 1);
  EXPECT_FALSE(j["findings"][1].contains("area_mm2"));
  EXPECT_FALSE(j["findings"][1]["source"].contains("block"));
  EXPECT_FALSE(j["findings"][2].contains("where"));
  EXPECT_EQ(j["comparison"]["max_gouge_mm"], 0.25);
  EXPECT_EQ(j["comparison"]["histogram"]["edges_mm"].size(), 61u);
  EXPECT_EQ(j["comparison"]["histogram"]["area_mm2"].size(), 60u);
  EXPECT_TRUE(j["comparison"]["deciding_resolution_mm"].is_null());
  EXPECT_EQ(j["error_budget"][0]["bound_mm"], 0.0012);
  EXPECT_TRUE(j["error_budget"][3]["bound_mm"].is_null());
  EXPECT_EQ(j["diagnostics"][0]["source"]["line"], 3);
  EXPECT_EQ(j["hashes"]["inputs"][1]["sha256"], std::string(64, 'b'));
  EXPECT_EQ(j["hashes"]["part_sha256"], std::string(64, 'c'));
  EXPECT_EQ(j["outputs"]["meshes"][0]["path"], "part.stl");
  EXPECT_EQ(j["outputs"]["html"], "report.html");
  EXPECT_EQ(j["performance"]["wall_s"], 3.25);
  EXPECT_EQ(j["performance"]["read_s"], 0.15);
  EXPECT_EQ(j["performance"]["peak_memory_mb"], 412.0);
  EXPECT_EQ(j["performance"]["predicted_memory_mb"], 380.0);
  EXPECT_EQ(j["performance"]["predicted_s"], 3.5);
  EXPECT_EQ(j["checks"]["fixtures"], true);
}

TEST(ReportJson, HasTheFeaturesOfACadModel) {
  Report report = io_test::sampleReport();
  EXPECT_FALSE(Json::parse(reportJson(report))["comparison"].contains("features"));
  report.comparison->features = io_test::sampleFeatures();
  report.findings.front().feature = "hole of diameter 8 at X20.000 Y5.000";
  const Json j = Json::parse(reportJson(report));
  const Json& features = j["comparison"]["features"];
  ASSERT_EQ(features.size(), 2u);
  EXPECT_EQ(features[0]["characteristics"][0]["name"], "diameter");
  EXPECT_NEAR(features[0]["characteristics"][0]["deviation"].get<double>(), 0.02, 1e-9);
  EXPECT_EQ(features[0]["id"], "F1");
  EXPECT_EQ(features[0]["characteristics"][0]["verdict"], "fail");
  EXPECT_EQ(features[0]["characteristics"][0]["upper"], 0.015);
  EXPECT_FALSE(features[0]["characteristics"][1].contains("lower"));
  EXPECT_TRUE(features[1]["missing"].get<bool>());
  EXPECT_FALSE(j["comparison"]["features_found"].get<bool>());
  EXPECT_FALSE(features[0].contains("residual_mm"));
  report.comparison->features_found = true;
  report.comparison->features[0].residual_mm = 2e-5;
  const Json found = Json::parse(reportJson(report))["comparison"];
  EXPECT_TRUE(found["features_found"].get<bool>());
  EXPECT_EQ(found["features"][0]["residual_mm"], 2e-5);
  EXPECT_EQ(j["findings"][0]["feature"], "hole of diameter 8 at X20.000 Y5.000");
}

TEST(ReportJson, TellsAlignmentAndScan) {
  Report report = io_test::sampleReport();
  EXPECT_FALSE(Json::parse(reportJson(report))["comparison"].contains("alignment"));
  EXPECT_FALSE(Json::parse(reportJson(report))["comparison"].contains("scan"));
  report.comparison->alignment = io_test::sampleAlignment();
  report.comparison->scan = io_test::sampleScan();
  const Json j = Json::parse(reportJson(report))["comparison"];
  EXPECT_EQ(j["alignment"]["kind"], "fit");
  EXPECT_EQ(j["alignment"]["matrix"][0][3], 0.25);
  EXPECT_EQ(j["alignment"]["matrix"][1][0], 0.0);
  EXPECT_EQ(j["alignment"]["matrix"][2][2], 1.0);
  EXPECT_EQ(j["alignment"]["rms_mm"], 0.0201);
  EXPECT_EQ(j["alignment"]["moved_mm"], 0.25);
  EXPECT_EQ(j["alignment"]["turned_deg"], 0.0);
  EXPECT_EQ(j["alignment"]["points"], 12345);
  EXPECT_EQ(j["alignment"]["left_out"], 32);
  EXPECT_EQ(j["alignment"]["free_directions"], 1);
  EXPECT_EQ(j["scan"]["file"], "<scan>.ply");
  EXPECT_EQ(j["scan"]["kind"], "points");
  EXPECT_EQ(j["scan"]["points"], 98765);
  EXPECT_EQ(j["scan"]["off"], 12);
  EXPECT_EQ(j["scan"]["coverage"], 0.6219);
  EXPECT_EQ(j["scan"]["reach_mm"], 0.375);
}

TEST(ReportJson, KeepsTheOrderOfKeys) {
  std::vector<std::string> keys;
  const Json j = Json::parse(reportJson(io_test::sampleReport()));
  for (const auto& [key, value] : j.items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("schema", "version", "name", "verdict", "checks", "program", "setups", "time",
                                "accounting", "stock", "resolution_mm", "findings", "comparison",
                                "error_budget", "diagnostics", "hashes", "outputs", "performance"));
}

TEST(ReportJson, WithoutPerformanceDependsOnTheInputsAlone) {
  Report a = io_test::sampleReport(), b = a;
  b.performance.wall_s = 99;
  b.performance.threads = 7;
  EXPECT_EQ(reportJson(a, {false}), reportJson(b, {false}));
  EXPECT_NE(reportJson(a), reportJson(b));
  EXPECT_FALSE(Json::parse(reportJson(a, {false})).contains("performance"));
}

TEST(ReportJson, SaysWhatIsNotThere) {
  const Json j = Json::parse(reportJson(Report()));
  EXPECT_EQ(j["verdict"], "error");
  EXPECT_TRUE(j["stock"].is_null());
  EXPECT_TRUE(j["accounting"].is_null());
  EXPECT_TRUE(j["comparison"].is_null());
  EXPECT_TRUE(j["resolution_mm"].is_null());
  EXPECT_EQ(j["findings"].size(), 0u);
}

TEST(ReportJson, SurvivesOddValues) {
  Report r = io_test::sampleReport();
  r.findings[0].depth_mm = std::numeric_limits<double>::quiet_NaN();
  r.findings[0].source->text = "N1 (\xcf\xf0\xee\xe3\x00)";
  r.name = "\xff\xfe\"\n";
  const std::string text = reportJson(r);
  const Json j = Json::parse(text);
  EXPECT_TRUE(j["findings"][0]["depth_mm"].is_null());
  EXPECT_EQ(j["name"], "\xEF\xBF\xBD\xEF\xBF\xBD\"\n");
  EXPECT_THAT(text, Not(HasSubstr("-0.0,")));
  EXPECT_EQ(text.back(), '\n');
}

}  // namespace
}  // namespace proveout

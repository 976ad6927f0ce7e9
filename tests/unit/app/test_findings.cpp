#include <gtest/gtest.h>

#include "app/run_report.h"
#include "app/session/findings/contact_findings.h"
#include "app/session/findings/findings.h"
#include "app/session/machining/stock_bodies.h"

namespace proveout {
namespace {

struct Fixture : testing::Test {
  Fixture() : memory("plate.nc", "N10 G0 Z5\nN20 G1 X5\n"), source(memory, TextEncoding::kAuto) {
    EXPECT_TRUE(source.mainProgram().ok());
    path.files = {"plate.nc"};
    path.motions.resize(2);
    path.motions[0].source = {0, 1, 10, 0};
    path.motions[1].source = {0, 2, 20, 0};
    path.motions[1].tool = 4;
  }
  MemoryProgramSource memory;
  RecordingSource source;
  Toolpath path;
  std::vector<Finding> findings;
};

constexpr double kLeast = 0.01;  ///< mm

TEST_F(Fixture, ContactNamesBlockToolAndPlace) {
  path.motions[1].spindle = 1000;
  addContacts({{ContactKind::kHolder, 1, 1, {1, 2, 3}, 0.25, 7.0}}, kLeast, path, source, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kHolderContact);
  EXPECT_EQ(findings[0].severity, Severity::kError);
  EXPECT_EQ(findings[0].source->block, 20);
  EXPECT_EQ(findings[0].tool, 4);
  const std::string text = formatDiagnostic(findingDiagnostic(findings[0]));
  EXPECT_EQ(text.rfind("plate.nc:2: error[holder_contact]: ", 0), 0u) << text;
  EXPECT_NE(text.find("N20 G1 X5"), std::string::npos);
  EXPECT_NE(text.find("X1.000 Y2.000 Z3.000, tool 4"), std::string::npos);
}

TEST_F(Fixture, SpindleThatIsNeverStartedIsOneWarning) {
  const std::vector<Contact> contacts = {{ContactKind::kSpindleOff, 0, 0, {}, 1, 1},
                                         {ContactKind::kSpindleOff, 1, 1, {}, 1, 1}};
  addContacts(contacts, kLeast, path, source, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  findings.clear();
  path.motions[0].spindle = -500;
  path.motions[1].tool = path.motions[0].tool;
  addContacts(contacts, kLeast, path, source, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kError);
  EXPECT_EQ(findings[0].source->line, 1u);
  EXPECT_EQ(findings[0].last_source->line, 2u);
}

TEST_F(Fixture, ContactsOfOneMistakeAreOneFinding) {
  path.motions.assign(100, path.motions[1]);
  const auto at = [](MotionId motion, double x, double depth) {
    return Contact{ContactKind::kRapid, motion, motion, {x, 0, 0}, depth, 2.0};
  };
  // Blocks that follow each other; the next layer beside them; another place; what is less than is asked for.
  addContacts({at(1, 0, 0.2), at(2, 0, 0.5), at(40, 2, 0.3), at(80, 50, 0.1), at(90, 90, 0.005)}, kLeast,
              path, source, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].spots, 3u);
  EXPECT_EQ(findings[0].motion, 1u);
  EXPECT_EQ(findings[0].depth_mm, 0.5);
  EXPECT_EQ(findings[0].volume_mm3, 6.0);
  EXPECT_EQ(findings[1].motion, 80u);
}

TEST_F(Fixture, AnEmptyPartIsAnError) {
  addOutcome(4000, 0, {}, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kNoPart);
  EXPECT_EQ(findings[0].severity, Severity::kError);
}

TEST_F(Fixture, NothingCutAndLoosePiecesAreWarnings) {
  const StockBody part{3000, {{0, 0, 0}, {20, 15, 10}}, "part"};
  const StockBody chip{200, {{0, 18, 0}, {20, 19, 10}}, "loose"};
  addOutcome(4000, 3000, {part}, findings);
  EXPECT_TRUE(findings.empty());
  addOutcome(3000, 3000, {part}, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kNothingCut);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  addOutcome(4000, 3200, {part, chip}, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[1].kind, FindingKind::kLoosePiece);
  EXPECT_EQ(findings[1].severity, Severity::kWarning);
  EXPECT_DOUBLE_EQ(*findings[1].volume_mm3, 200);
}

TEST_F(Fixture, WhatIsThinnerThanTheGridIsAWarning) {
  RemovalSummary removal;
  StockSurface surface;
  addThinFeatures(removal, surface, 0.5, path, source, findings);
  EXPECT_TRUE(findings.empty());
  removal.lost_film_mm2 = 12;
  removal.lost_film_at = {1, 2, 3};
  surface.thin_cells = 4;
  surface.facets = {0.2, {4, 5, 6}};
  addThinFeatures({}, surface, 0.5, path, source, findings);  // less than half a step
  EXPECT_TRUE(findings.empty());
  surface.facets.mm = 0.3;
  addThinFeatures(removal, surface, 0.5, path, source, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].kind, FindingKind::kThinFeature);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_EQ(*findings[0].where, Vec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(*findings[0].area_mm2, 12);
  EXPECT_DOUBLE_EQ(*findings[1].area_mm2, 1);
  EXPECT_EQ(*findings[1].where, Vec3(4, 5, 6));
}

TEST_F(Fixture, ACutNarrowerThanTheGridNamesToolBlockAndGrid) {
  RemovalSummary removal;
  removal.narrow_cuts = {{1, {4, 5, 6}, 0.15, 20, 3}};
  addThinFeatures(removal, {}, 0.5, path, source, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kThinFeature);
  EXPECT_EQ(findings[0].tool, 4);
  EXPECT_EQ(findings[0].source->block, 20);
  EXPECT_EQ(*findings[0].where, Vec3(4, 5, 6));
  EXPECT_DOUBLE_EQ(*findings[0].area_mm2, 3);
  EXPECT_NE(findings[0].message.find("--resolution 0.1 "), std::string::npos) << findings[0].message;
}

TEST_F(Fixture, AnEarlyStopIsSaid) {
  ControlSettings settings;
  settings.until = UntilBlock{{}, 120};
  addPartial(ProgramEnd::kEndOfProgram, settings, findings);
  EXPECT_TRUE(findings.empty());
  addPartial(ProgramEnd::kUntil, settings, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kPartial);
  EXPECT_NE(findings[0].message.find("up to N120"), std::string::npos);
}

TEST_F(Fixture, DeviationsAndUndecided) {
  Comparison comparison;
  comparison.gouge_tolerance_mm = 0.02;
  comparison.excess_tolerance_mm = 0.05;
  DeviationPatch gouge;
  gouge.depth_mm = 0.5;
  DeviationPatch unsure;
  unsure.kind = DeviationKind::kExcess;
  unsure.depth_mm = 0.055;
  unsure.bound_mm = 0.01;
  unsure.deciding_resolution_mm = 0.1;
  comparison.patches = {gouge};
  DeviationPatch less = unsure;
  less.depth_mm = 0.048;
  less.deciding_resolution_mm = 0.2;
  comparison.undecided = {less, unsure};
  addDeviation(gouge, comparison, findings);
  EXPECT_EQ(addUndecided(comparison, findings), &comparison.undecided[1]);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].kind, FindingKind::kGouge);
  EXPECT_EQ(findings[1].kind, FindingKind::kUndecided);
  EXPECT_EQ(findings[1].severity, Severity::kWarning);
  EXPECT_FALSE(findings[1].source.has_value());
  EXPECT_NE(findings[1].message.find("0.055 mm above"), std::string::npos);
  EXPECT_NE(findings[1].message.find("--resolution 0.1"), std::string::npos);
  EXPECT_NE(findings[1].message.find("1 other place"), std::string::npos);
  const ReportComparison report = reportComparison(comparison, NominalSpec{});
  EXPECT_FALSE(report.decided);
  EXPECT_DOUBLE_EQ(*report.deciding_resolution_mm, 0.1);
}

TEST_F(Fixture, WhatTheNominalsFacetsLeaveOpenAsksForAFinerNominal) {
  Comparison comparison;
  comparison.gouge_tolerance_mm = 0.02;
  comparison.excess_tolerance_mm = 0.05;
  DeviationPatch unsure;
  unsure.depth_mm = 0.04;
  unsure.bound_mm = 0.06;
  unsure.chord_mm = 0.059;
  comparison.undecided = {unsure};
  addUndecided(comparison, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_EQ(findings[0].message.find("--resolution"), std::string::npos) << findings[0].message;
  for (const char* const told :
       {"0.04 mm below nominal", "good to 0.06 mm", "0.059 mm off the face", "chords of 0.002 mm"})
    EXPECT_NE(findings[0].message.find(told), std::string::npos) << findings[0].message;
  EXPECT_FALSE(reportComparison(comparison, NominalSpec{}).decided);
}

TEST_F(Fixture, OfFacetsTheProfileDecides) {
  Comparison comparison;
  comparison.gouge_tolerance_mm = 0.02;
  DeviationPatch unsure;
  unsure.allowed_mm = 0.02;
  unsure.depth_mm = 0.015;
  unsure.bound_mm = 0.01;  // of a profile resolution of 0.1 mm: half would do, with a margin 0.4
  comparison.undecided = {unsure};
  addUndecided(comparison, findings, 0.1);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(findings[0].message.find("; profile_resolution = 0.04 in the job could"), std::string::npos)
      << findings[0].message;
  comparison.undecided[0].depth_mm = 0.02;  // at the tolerance: nothing decides
  addUndecided(comparison, findings, 0.1);
  EXPECT_EQ(findings[1].message.find("could"), std::string::npos) << findings[1].message;
}

TEST_F(Fixture, OvertravelAndAlarms) {
  PathEvent event;
  event.what = event::Overtravel{"X", 412.5, 400.0, {}};
  event.source = {0, 2, 20, 0};
  path.events.push_back({1, event});
  Diagnostic alarm;
  alarm.message = "wrong";
  alarm.where = {"plate.nc", 2, 1, 2};
  path.diagnostics.add(alarm);
  addAlarms(path, findings);
  addOvertravel(path, source, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].kind, FindingKind::kAlarm);
  EXPECT_EQ(findings[1].message, "X goes to 412.5 mm, past its limit of 400 mm (machine frame)");
  EXPECT_EQ(findings[1].motion, 1u);
}

/// The pieces of one block tell the farthest place of each axis; another block is told by itself.
TEST_F(Fixture, OvertravelIsToldOnceABlock) {
  PathEvent event;
  event.source = {0, 2, 20, 0};
  for (const double x : {401.0, 407.0, 404.0}) {
    event.what = event::Overtravel{"X", x, 400.0, {}};
    path.events.push_back({kNoMotion, event});
    event.what = event::Overtravel{"Y", -5.0, 0.0, {}};
    path.events.push_back({kNoMotion, event});
  }
  event.source = {0, 1, 10, 0};
  event.what = event::Overtravel{"X", 402.0, 400.0, {}};
  path.events.push_back({kNoMotion, event});
  addOvertravel(path, source, findings);
  ASSERT_EQ(findings.size(), 3u);
  EXPECT_EQ(findings[0].message, "X goes to 407 mm, past its limit of 400 mm (machine frame)");
  EXPECT_EQ(findings[1].message, "Y goes to -5 mm, past its limit of 0 mm (machine frame)");
  EXPECT_EQ(findings[2].message, "X goes to 402 mm, past its limit of 400 mm (machine frame)");
}

TEST_F(Fixture, AForbiddenZoneNamesItsBlockAndPlace) {
  PathEvent event;
  event.what = event::ForbiddenZone{2, 3042, "inner forbidden zone 2"};
  event.source = {0, 2, 20, 0};
  path.events.push_back({1, event});
  event.source = {0, 1, 10, 0};
  path.events.push_back({2, event});
  addForbiddenZones(path, source, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].source->block, 20);
  EXPECT_EQ(findings[0].motion, 1u);
  EXPECT_EQ(findings[0].message, "inner forbidden zone 2 (alarm 3042 of the control)");
  EXPECT_EQ(findings[1].source->block, 10);
  EXPECT_FALSE(findings[1].motion.has_value());
}

void addBox(TriMesh& mesh, const Vec3& lo, const Vec3& hi, bool inward) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i < 8; ++i) {
    const Vec3 p((i & 1) ? hi.x() : lo.x(), (i & 2) ? hi.y() : lo.y(), (i & 4) ? hi.z() : lo.z());
    mesh.positions.push_back(p.cast<float>());
  }
  constexpr std::uint32_t kFaces[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                           {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  for (const auto& f : kFaces) {
    const std::uint32_t b = inward ? f[2] : f[1], c = inward ? f[1] : f[2];
    mesh.triangles.push_back({base + f[0], base + b, base + c});
  }
}

TEST(StockBodies, LargestIsThePartAndHollowsCountAgainstTheirBody) {
  TriMesh mesh;
  addBox(mesh, {20, 0, 0}, {22, 2, 2}, false);
  addBox(mesh, {0, 0, 0}, {10, 10, 10}, false);
  addBox(mesh, {4, 4, 4}, {6, 6, 6}, true);
  const std::vector<StockBody> bodies = stockBodies(mesh, analyseTopology(mesh), meshExtent(mesh), 1000.5);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].role, "part");
  EXPECT_NEAR(bodies[0].volume_mm3, 992.5, 1e-3);  // the mesh encloses 0.5 less than there is
  EXPECT_EQ(bodies[1].role, "loose");
  EXPECT_NEAR(bodies[1].volume_mm3, 8.0, 1e-3);
  EXPECT_TRUE(stockBodies(TriMesh{}, MeshTopology{}, MeshExtent{}, 0.0).empty());
}

TEST(MeshDefects, OfFreedPiecesAreTold) {
  std::vector<Finding> findings;
  addFreedDefects(0, findings);
  EXPECT_TRUE(findings.empty());
  addFreedDefects(3, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, FindingKind::kMesh);
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_EQ(findings[0].message.rfind("3 pairs of the freed pieces' triangles", 0), 0u);
}

}  // namespace
}  // namespace proveout

// Whole runs with a wire: threading, stops, clamps, the choice of the part, what cutting lacks,
// slugs that fall, stay or hang on (wedm-x-slug).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/session/run/process.h"
#include "app/session/session.h"
#include "removal/wire/section/prism_mesh.h"

namespace proveout {
namespace {

/// A plate of 40 x 40 x 20, a wire of 0.2 with a gap of 0.01.
Job plateJob() {
  Job job;
  job.name = "plate";
  job.control = "wedm";
  job.stock = BoxShape{{-20, -20, 0}, {20, 20, 20}};
  Tool wire;
  wire.number = 1;
  wire.type = ToolType::kWire;
  wire.diameter = 0.2;
  wire.spark_gap = 0.01;
  job.tools = {wire};
  return job;
}

const std::string kStart = "T84T86;\nC001;\nG92X0Y0;\n";
/// Round about the origin with radius 5, and back to the start.
const std::string kRing = "G01X5.;\nG02X-5.I-5.;\nX5.I5.;\nM00;\nG01X0;\n";

Result<RunResult> run(const Job& job, const std::string& program, const TriMesh* nominal = nullptr) {
  const MemoryProgramSource memory("plate.nc", program);
  const RecordingSource source(memory, TextEncoding::kAuto);
  Progress progress;
  if (nominal == nullptr) return runRecorded(job, {&source}, progress);
  Result<PreparedRun> prepared = prepareRun(job, {&source}, progress);
  if (!prepared) return prepared.error();
  Job compared = job;
  compared.nominal = NominalSpec{};
  compared.nominal->gouge_mm = compared.nominal->excess_mm = 0.01;
  prepared->nominal.emplace();
  prepared->nominal->mesh = *nominal;
  return finishRun(compared, {&source}, std::move(*prepared), progress);
}

/// The findings of a kind; a run that failed has none, and fails the test.
std::vector<Finding> found(const Result<RunResult>& result, FindingKind kind) {
  std::vector<Finding> out;
  EXPECT_TRUE(result.ok()) << result.error().message;
  if (!result.ok()) return out;
  for (const Finding& finding : result->findings) {
    if (finding.kind == kind) out.push_back(finding);
  }
  return out;
}

std::vector<Finding> errors(const Result<RunResult>& result) {
  std::vector<Finding> out;
  EXPECT_TRUE(result.ok()) << result.error().message;
  if (!result.ok()) return out;
  for (const Finding& finding : result->findings) {
    if (finding.severity == Severity::kError) out.push_back(finding);
  }
  return out;
}

std::string firstText(const std::vector<Finding>& findings) {
  return findings.empty() ? "none" : findings.front().message;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(WireRuns, StartHolesAreHollowsOfTheBlank) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const Result<RunResult> result = run(job, kStart + kRing + "M02;\n");
  EXPECT_TRUE(errors(result).empty()) << firstText(errors(result));
  const SetupRun& setup = result->setups.front();
  EXPECT_NEAR(setup.initial_mm3, 20 * (1600 - 0.25 * kPi), 1e-3);
  ASSERT_EQ(setup.bodies.size(), 2u);
  // The slug has the hole and the slot of the way out.
  const double slot = (4.89 - 0.5) * 0.22;
  EXPECT_NEAR(setup.bodies[1].volume_mm3, 20 * (kPi * 4.89 * 4.89 - 0.25 * kPi - slot), 1.0);
  EXPECT_TRUE(setup.topology.closedManifold());
}

TEST(WireRuns, StartHolesAreRefusedWhereTheyCannotBe) {
  Job job = plateJob();
  job.start_holes = {{{20, 0}, 1.0}};
  const Result<RunResult> outside = run(job, kStart + "M02;\n");
  ASSERT_FALSE(outside.ok());
  EXPECT_EQ(outside.error().kind, ErrorKind::kInput);
  job.control = "nct";
  job.start_holes = {{{0, 0}, 1.0}};
  const Result<RunResult> milled = run(job, "M30\n");
  ASSERT_FALSE(milled.ok());
  EXPECT_TRUE(has(milled.error().message, "control nct mills: leave [[stock.start_hole]] out"))
      << milled.error().message;
}

TEST(WireRuns, AWireNeedsAHole) {
  Job job = plateJob();
  const auto threading = [&](const std::string& program) {
    return found(run(job, program), FindingKind::kThreading);
  };
  std::vector<Finding> faults = threading(kStart + kRing + "M02;\n");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].severity, Severity::kError);
  EXPECT_EQ(faults[0].source->line, 4u);
  EXPECT_TRUE(has(faults[0].message, "no hole to thread the wire through at X0.000 Y0.000"))
      << faults[0].message;
  EXPECT_TRUE(has(faults[0].message, "the wire of 0.2 mm needs a start hole"));
  job.start_holes = {{{0, 0}, 0.15}};
  faults = threading(kStart + kRing + "M02;\n");
  EXPECT_TRUE(has(firstText(faults), "the start hole of 0.15 mm at X0.000 Y0.000 is too small"))
      << firstText(faults);
  job.start_holes = {{{0.45, 0}, 1.0}};
  faults = threading(kStart + kRing + "M02;\n");
  EXPECT_TRUE(has(firstText(faults), "touches the wall of the start hole of 1 mm")) << firstText(faults);
  EXPECT_TRUE(has(firstText(faults), "wider than 1.1 mm")) << firstText(faults);
  job.start_holes = {{{0.39, 0}, 1.0}};
  EXPECT_TRUE(threading(kStart + kRing + "M02;\n").empty());
  // Outside of the stock nothing is in the way.
  job.start_holes.clear();
  EXPECT_TRUE(threading("T84T86;\nC001;\nG92X-25.Y0;\nG01X0;\nM02;\n").empty());
}

TEST(WireRuns, ThreadingAgainNeedsAHoleAsWell) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const std::string second = "M50;\nG00X12.;\nM60;\nG01X15.;\nM02;\n";
  const std::vector<Finding> faults = found(run(job, kStart + kRing + second), FindingKind::kThreading);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].source->text, "M60;");
  job.start_holes.push_back({{12, 0}, 1.0});
  EXPECT_TRUE(errors(run(job, kStart + kRing + second)).empty());
  // Where it has cut before there is room.
  EXPECT_TRUE(errors(run(job, kStart + "G01X5.;\nM50;\nG00X3.;\nM60;\nG01X5.;\nM02;\n")).empty());
}

TEST(WireRuns, AWireThatIsCutOffTouchesNothing) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}, {{12, 0}, 1.0}};
  const Result<RunResult> off = run(job, kStart + "G01X5.;\nM50;\nG00X12.;\nM60;\nM02;\n");
  EXPECT_TRUE(found(off, FindingKind::kRapidContact).empty());
  const Result<RunResult> on = run(job, kStart + "G01X5.;\nG00X12.;\nM02;\n");
  const std::vector<Finding> contacts = found(on, FindingKind::kRapidContact);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].severity, Severity::kError);
}

TEST(WireRuns, BehindAStopTheOperatorThreads) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}, {{12, 0}, 1.0}};
  const std::string next = "M00;\nG00X12.;\nM00;\nG01X15.;\nM02;\n";
  const Result<RunResult> result = run(job, kStart + kRing + next);
  EXPECT_TRUE(errors(result).empty()) << firstText(errors(result));
  const std::vector<Finding> notes = found(result, FindingKind::kRapidContact);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].severity, Severity::kNote);
  EXPECT_TRUE(has(notes[0].message, "the operator has to cut the wire at the stop")) << notes[0].message;
  job.start_holes.pop_back();
  const std::vector<Finding> faults = found(run(job, kStart + kRing + next), FindingKind::kThreading);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].source->text, "G01X15.;");
}

TEST(WireRuns, APointSaysWhichBodyIsThePart) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const auto partVolume = [&](const Vec3& point) {
    job.part_point = point;
    const Result<RunResult> result = run(job, kStart + kRing + "M02;\n");
    return result.ok() ? result->setups.front().bodies.front().volume_mm3 : -1.0;
  };
  EXPECT_GT(partVolume({10, 10, 10}), 20000.0);
  EXPECT_LT(partVolume({-2, 2, 10}), 2000.0);
  EXPECT_GT(partVolume({-2, 2, 0}), 0.0) << "the bottom is in the part";
  for (const Vec3& point : {Vec3(0, 5, 10), Vec3(0, 0, 10), Vec3(30, 0, 10), Vec3(-2, 2, 21)}) {
    job.part_point = point;
    const Result<RunResult> result = run(job, kStart + kRing + "M02;\n");
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().kind, ErrorKind::kInput);
    EXPECT_TRUE(has(result.error().message, "lies in no body")) << result.error().message;
  }
  job.part_point = Vec3(0, 5, 10);
  const std::string text = run(job, kStart + kRing + "M02;\n").error().message;
  EXPECT_TRUE(has(text, "0.11 mm away")) << text;
  EXPECT_TRUE(has(text, "X-20.000 Y-20.000 to X20.000 Y20.000")) << text;
}

TEST(WireRuns, ClampsAreNotCutThrough) {
  Job job = plateJob();
  job.fixtures = {{"strap", BoxShape{{10, -2, 20}, {30, 2, 25}}}};
  const std::string program = "T84T86;\nC001;\nG92X-25.Y0;\nG01X0;\nN20X15.;\nN30X0;\nM02;\n";
  const Result<RunResult> result = run(job, program);
  const std::vector<Finding> contacts = found(result, FindingKind::kFixtureContact);
  ASSERT_EQ(contacts.size(), 1u) << "there and back is one";
  EXPECT_EQ(contacts[0].severity, Severity::kError);
  EXPECT_EQ(contacts[0].source->block, 20);
  EXPECT_EQ(contacts[0].last_source->block, 30);
  EXPECT_TRUE(has(contacts[0].message, "the wire runs into fixture 'strap'")) << contacts[0].message;
  // In rapid, and not where the wire is cut off.
  job.start_holes = {{{-15, 0}, 1.0}};
  const auto touched = [&](const std::string& text) {
    return found(run(job, text), FindingKind::kFixtureContact).size();
  };
  EXPECT_EQ(touched("T84T86;\nC001;\nG92X25.Y-25.;\nG00Y25.;\nM02;\n"), 1u);
  EXPECT_EQ(touched("T84T86;\nC001;\nG92X25.Y-25.;\nM50;\nG00Y25.;\nM02;\n"), 0u);
  EXPECT_EQ(touched("T84T86;\nC001;\nG92X25.Y-25.;\nG00Y-2.2;\nM02;\n"), 0u);
}

TEST(WireRuns, WhatAClampHoldsIsThePart) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const Result<RunResult> frame = run(job, kStart + kRing + "M02;\n");
  ASSERT_TRUE(frame.ok());
  EXPECT_GT(frame->setups.front().bodies.front().volume_mm3, 20000.0);
  job.fixtures = {{"magnet", CylinderShape{2, {-2, 2, 20}, 1, 0, 5}}};
  const Result<RunResult> punch = run(job, kStart + kRing + "M02;\n");
  EXPECT_TRUE(errors(punch).empty()) << firstText(errors(punch));
  EXPECT_LT(punch->setups.front().bodies.front().volume_mm3, 2000.0);
  EXPECT_EQ(punch->setups.front().bodies.front().role, "part");
  job.part_point = Vec3(10, 10, 10);
  EXPECT_GT(run(job, kStart + kRing + "M02;\n")->setups.front().bodies.front().volume_mm3, 20000.0);
}

TEST(WireRuns, WhatCuttingLacks) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const auto supply = [&](const std::string& program) {
    return found(run(job, program), FindingKind::kWireSupply);
  };
  EXPECT_TRUE(supply(kStart + kRing + "M02;\n").empty());
  const std::vector<Finding> broken =
      supply(kStart + "G01X5.;\nT87;\nG02X-5.I-5.;\nX5.I5.;\nT86;\nG01X8.;\nT85;\nX9.;\nM02;\n");
  ASSERT_EQ(broken.size(), 2u);
  EXPECT_EQ(broken[0].severity, Severity::kError);
  EXPECT_EQ(broken[0].source->text, "G02X-5.I-5.;");
  EXPECT_EQ(broken[0].last_source->text, "X5.I5.;");
  EXPECT_EQ(broken[0].message, "the wire cuts here while the wire does not run");
  EXPECT_EQ(broken[1].message, "the wire cuts here while there is no fluid");
  // What the program never does is the operator's.
  const std::vector<Finding> never = supply("G92X0Y0;\n" + kRing + "M02;\n");
  ASSERT_EQ(never.size(), 1u);
  EXPECT_EQ(never[0].severity, Severity::kWarning);
  EXPECT_TRUE(
      has(never[0].message, "never runs the wire, switches the fluid on nor chooses a cutting condition"))
      << never[0].message;
  const std::vector<Finding> late = supply("T84T86;\nG92X0Y0;\nG01X5.;\nC001;\nX7.;\nM02;\n");
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].message, "the wire cuts here while no cutting condition is chosen");
  // Through air nothing happens.
  EXPECT_TRUE(supply("T84T86;\nC001;\nG92X-30.Y0;\nT87;\nG01X-25.;\nT86;\nX0;\nM02;\n").empty());
}

TEST(WireRuns, AFreeSlugIsToldWhereTheWireGoesOn) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const std::string ring = "G01X5.;\nG02X-5.I-5.;\nX5.I5.;\n";
  const std::vector<Finding> slugs =
      found(run(job, kStart + ring + "G01X0;\nM02;\n"), FindingKind::kFreeSlug);
  ASSERT_EQ(slugs.size(), 1u);
  EXPECT_EQ(slugs[0].severity, Severity::kWarning);
  EXPECT_EQ(slugs[0].source->text, "X5.I5.;");
  EXPECT_TRUE(
      has(slugs[0].message, "mm3 is free here, and plate.nc:7 goes on through where it may still lie"))
      << slugs[0].message;
  EXPECT_NEAR(*slugs[0].volume_mm3, 20 * (kPi * 4.89 * 4.89 - 0.25 * kPi - 4.39 * 0.22), 1.0);
  EXPECT_TRUE(found(run(job, kStart + kRing + "M02;\n"), FindingKind::kFreeSlug).empty()) << "a stop";
  EXPECT_TRUE(found(run(job, kStart + ring + "G01X8.;\nM02;\n"), FindingKind::kFreeSlug).empty());
}

TEST(WireRuns, WhatFellIsNotCutByWhatFollows) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const auto slug = [&](const std::string& more) {
    const Result<RunResult> result = run(job, kStart + kRing + more + "M02;\n");
    EXPECT_TRUE(result.ok());
    EXPECT_EQ(result->setups.front().bodies.size(), 2u);
    double removed = 0.0;
    for (const float mm3 : result->setups.front().removal.removed_mm3) removed += mm3;
    EXPECT_NEAR(removed, result->setups.front().initial_mm3 - result->setups.front().surface.volume_mm3,
                0.05);
    return result->setups.front().bodies[1].volume_mm3;
  };
  const double alone = slug("");
  EXPECT_NEAR(slug("G01X-4.;\nX0;\n"), alone, 1e-6);
}

TEST(WireRuns, AForgottenOffsetIsTheCause) {
  Job job = plateJob();
  PlaneBody body;
  body.loops.push_back(rectangleLoop({-5, -5}, {5, 5}));
  const TriMesh nominal = prismMesh({body}, 0, 20, 1e-3);
  const auto gouges = [&](const std::string& offset) {
    return found(run(job,
                     "H001=110;\nT84T86;\nC001;\nG92X-25.Y0;\n" + offset +
                         "G01X-5.;\nY5.;\nX5.;\nY-5.;\nX-5.;\nY0;\nG40X-25.;\nM02;\n",
                     &nominal),
                 FindingKind::kGouge);
  };
  EXPECT_TRUE(gouges("G41H001").empty());
  for (const char* offset : {"", "G41H000"}) {
    const std::vector<Finding> all = gouges(offset);
    ASSERT_FALSE(all.empty());
    for (const Finding& gouge : all) {
      ASSERT_FALSE(gouge.causes.empty());
      EXPECT_EQ(gouge.causes[0].what, kNoOffset);
      EXPECT_EQ(gouge.causes[0].value, "the wire's kerf is 0.11 mm to each side");
      EXPECT_NEAR(*gouge.causes[0].off_mm, -0.11, 1e-9);
      EXPECT_GT(gouge.causes[0].explains, 0.5);
      EXPECT_TRUE(gouge.causes[0].source.has_value());
    }
  }
}

TEST(WireRuns, LeaningWiresAreHandledAtAllHeights) {
  Job job = plateJob();
  const std::string taper = kStart + "G51A2.;\nG01X5.;\nG02X-5.I-5.;\nX5.I5.;\nM00;\nG50G01X0;\n";
  // The wire is upright where it is threaded.
  EXPECT_EQ(found(run(job, taper + "M02;\n"), FindingKind::kThreading).size(), 1u);
  job.start_holes = {{{0, 0}, 1.0}};
  const Result<RunResult> result = run(job, taper + "M02;\n");
  EXPECT_TRUE(errors(result).empty()) << firstText(errors(result));
  EXPECT_EQ(result->setups.front().bodies.size(), 2u);
  // 5.4 mm from the axis there is the slug at the top, and the die at the bottom.
  const auto partVolume = [&](double z) {
    job.part_point = Vec3(-5.4 * std::sqrt(0.5), 5.4 * std::sqrt(0.5), z);
    const Result<RunResult> chosen = run(job, taper + "M02;\n");
    return chosen.ok() ? chosen->setups.front().bodies.front().volume_mm3 : 0.0;
  };
  EXPECT_LT(partVolume(19.9), 2500.0);
  EXPECT_GT(partVolume(0.1), 20000.0);
  EXPECT_EQ(partVolume(21.0), 0.0);
  job.part_point.reset();
  job.fixtures = {{"magnet", CylinderShape{2, {-2, 2, 20}, 1, 0, 5}}};
  EXPECT_LT(run(job, taper + "M02;\n")->setups.front().bodies.front().volume_mm3, 2500.0);
  // A rapid with the wire that leans.
  EXPECT_EQ(
      found(run(job, kStart + "G51A2.;\nG01X5.;\nY2.;\nG00Y8.;\nM02;\n"), FindingKind::kRapidContact).size(),
      1u);
}

TEST(WireRuns, ASlugOfALeaningWireFallsAndIsCutNoMore) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  // Narrower at the top: the slug falls. G52 leans to the right of the way, to the middle.
  const auto program = [](const char* lean, const std::string& more) {
    return kStart + lean + "A2.;\nG01X5.;\nG03X-5.I-5.;\nX5.I5.;\nM00;\nG50G01X0;\n" + more + "M02;\n";
  };
  const std::string through = "G01X-4.;\nX0;\n";
  const auto slug = [&](const std::string& text) {
    const Result<RunResult> result = run(job, text);
    EXPECT_TRUE(result.ok());
    return result->setups.front().bodies[1];
  };
  const auto bodies = [&](const std::string& text) { return run(job, text)->setups.front().bodies.size(); };
  const StockBody alone = slug(program("G51", ""));
  EXPECT_EQ(alone.leaves, "down");
  EXPECT_NEAR(slug(program("G51", through)).volume_mm3, alone.volume_mm3, 1e-6);
  EXPECT_EQ(bodies(program("G51", through)), 2u);
  // Through all of it.
  EXPECT_NEAR(slug(program("G51", "G01X-5.;\nX0;\n")).volume_mm3, alone.volume_mm3, 1e-6);
  EXPECT_TRUE(found(run(job, program("G51", "")), FindingKind::kStuckSlug).empty());
  // Wider at the top it stays, and is cut.
  const StockBody stays = slug(program("G52", ""));
  EXPECT_EQ(stays.leaves, "up");
  EXPECT_LT(slug(program("G52", through)).volume_mm3, stays.volume_mm3 - 10.0);
  const std::vector<Finding> stuck = found(run(job, program("G52", "")), FindingKind::kStuckSlug);
  ASSERT_EQ(stuck.size(), 1u);
  EXPECT_EQ(stuck[0].source->text, "X5.I5.;");
  EXPECT_TRUE(has(stuck[0].message, "lift it out upwards")) << stuck[0].message;
  EXPECT_NEAR(*stuck[0].volume_mm3, stays.volume_mm3, 1e-6);
}

TEST(WireRuns, BridgesAreToldWithPlaceAndWidth) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  // A square whose last side ends 2 mm before the lead-in: 2 - 0.22 mm are left.
  const std::string open = "G01X5.;\nY5.;\nX-5.;\nY-5.;\nX5.;\nY-2.;\n";
  const std::vector<Finding> bridges = found(run(job, kStart + open + "M00;\nM02;\n"), FindingKind::kBridge);
  ASSERT_EQ(bridges.size(), 1u);
  EXPECT_EQ(bridges[0].severity, Severity::kWarning);
  EXPECT_TRUE(has(bridges[0].message, "by a bridge of 1.780 mm at X5.000 Y-1.000")) << bridges[0].message;
  EXPECT_TRUE(has(bridges[0].message, "not closed by 2.000 mm")) << bridges[0].message;
  EXPECT_EQ(bridges[0].source->text, "Y-2.;");
  EXPECT_NEAR(bridges[0].where->y(), -1.0, 1e-3);
  EXPECT_NEAR(*bridges[0].volume_mm3, 20 * (9.78 * 9.78 - 0.25 * kPi), 30.0);
  // With an offset and a way back to the middle, whose end is none of the contour.
  EXPECT_EQ(
      found(run(job, "H001=110;\n" + kStart + "G41H001;\n" + open + "G40X3.;\nM02;\n"), FindingKind::kBridge)
          .size(),
      1u);
  // Closed, or only a slit.
  EXPECT_TRUE(found(run(job, kStart + open + "Y0;\nM02;\n"), FindingKind::kBridge).empty());
  EXPECT_TRUE(found(run(job, kStart + "G01X9.;\nM02;\n"), FindingKind::kBridge).empty());
  EXPECT_TRUE(found(run(job, kStart + kRing + "M02;\n"), FindingKind::kBridge).empty());
}

TEST(WireRuns, TwoBridgesHoldAPiece) {
  Job job = plateJob();
  job.start_holes = {{{5, 0}, 0.4}, {{-5, 0}, 0.4}};
  const std::string two =
      "T84T86;\nC001;\nG92X5.Y0;\nG01Y5.;\nX-4.;\nM50;\nG00X-5.Y0;\nM60;\n"
      "G01Y-5.;\nX5.;\nY-1.;\nM50;\nG00X-5.Y0;\nM60;\nG01Y4.;\nM02;\n";
  const std::vector<Finding> bridges = found(run(job, two), FindingKind::kBridge);
  ASSERT_EQ(bridges.size(), 2u);
  for (const Finding& bridge : bridges) EXPECT_FALSE(bridge.volume_mm3.has_value());
}

TEST(WireRuns, BridgesOfLeaningWires) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const std::vector<Finding> bridges =
      found(run(job, kStart + "G51A2.;\nG01X5.;\nY5.;\nX-5.;\nY-5.;\nX5.;\nY-2.;\nM00;\nM02;\n"),
            FindingKind::kBridge);
  ASSERT_EQ(bridges.size(), 1u);
  EXPECT_TRUE(has(bridges[0].message, "by a bridge of 1.78")) << bridges[0].message;
}

TEST(WireRuns, OnTheGridHolesAreMissedAndBridgesTold) {
  Job job = plateJob();
  job.stock = CylinderShape{0, {-15, 0, 10}, 10, 0, 30};  // along X: no prism
  job.simulation.resolution_mm = 0.5;
  const std::string square = "G01X5.;\nY5.;\nX-5.;\nY-5.;\nX5.;\nY-2.;\nM00;\nM02;\n";
  const Result<RunResult> result = run(job, kStart + square);
  const std::vector<Finding> missing = found(result, FindingKind::kThreading);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_TRUE(has(missing[0].message, "there is no hole to thread the wire through at X0.000 Y0.000"))
      << missing[0].message;
  const std::vector<Finding> bridges = found(result, FindingKind::kBridge);
  ASSERT_EQ(bridges.size(), 1u);
  EXPECT_TRUE(has(bridges[0].message, "by a bridge of 1.780 mm")) << bridges[0].message;
  // From outside.
  EXPECT_TRUE(
      found(run(job, "T84T86;\nC001;\nG92X-25.Y0;\nG01X25.;\nM02;\n"), FindingKind::kThreading).empty());
}

TEST(WireRuns, LeaningTooFarIsAnAlarm) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  job.settings.parameters["MAX_TILT"] = 1.5;
  const Result<RunResult> result =
      run(job, kStart + "G51A2.;\nG01X5.;\nG02X-5.I-5.;\nX5.I5.;\nG50G01X0;\nM02;\n");
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_TRUE(result->alarm);
  const std::vector<Finding> alarms = found(result, FindingKind::kAlarm);
  ASSERT_EQ(alarms.size(), 1u);
  EXPECT_TRUE(has(alarms[0].message, "would lean")) << alarms[0].message;
  EXPECT_TRUE(has(alarms[0].message, "limit is 1.5")) << alarms[0].message;
  EXPECT_EQ(alarms[0].source->line, 5u);
}

TEST(WireRuns, APointInThePartMakesTheMeshThatOfThePartAlone) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  const std::string program = kStart + kRing + "M02;\n";
  const Result<RunResult> both = run(job, program);
  ASSERT_TRUE(both.ok());
  EXPECT_EQ(both->setups[0].mesh_bodies, 2u) << "nothing says which is the part";
  for (const double x : {15.0, 3.0}) {
    job.part_point = Vec3(x, 1, 10);
    const Result<RunResult> made = run(job, program);
    ASSERT_TRUE(made.ok()) << made.error().message;
    const SetupRun& setup = made->setups[0];
    EXPECT_EQ(setup.mesh_bodies, 1u);
    ASSERT_EQ(setup.bodies.size(), 2u);
    EXPECT_NEAR(setup.extent.volume_mm3, setup.bodies[0].volume_mm3, 1e-3 * setup.bodies[0].volume_mm3);
    ASSERT_EQ(setup.freed.size(), 1u);
    EXPECT_NEAR(meshVolume(setup.freed[0]), setup.bodies[1].volume_mm3, 1e-3 * setup.bodies[1].volume_mm3);
    EXPECT_EQ(setup.bodies[0].volume_mm3 > setup.bodies[1].volume_mm3, x > 10.0);
  }
  job.part_point = Vec3(5, 0, 10);
  const Result<RunResult> kerf = run(job, program);
  ASSERT_FALSE(kerf.ok());
  EXPECT_TRUE(has(kerf.error().message, "lies in no body that is left")) << kerf.error().message;
}

TEST(WireRuns, PiecesThatAreToBeWrittenAreNotInTheMesh) {
  Job job = plateJob();
  job.start_holes = {{{0, 0}, 1.0}};
  job.output.bodies = true;
  const Result<RunResult> made = run(job, kStart + kRing + "M02;\n");
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->setups[0].mesh_bodies, 1u);
  EXPECT_NEAR(made->setups[0].extent.volume_mm3, made->setups[0].bodies[0].volume_mm3, 1.0);
}

/// A slot whose upper shape is wider, in the middle of the blank.
const std::string kTwoShapes =
    "T84T86;C001;\nG92X-30.Y0U0V0;\nG61;\nG01X-8.Y0:G01X-4.Y0;\nX-8.Y8.:X-4.Y4.;\nX8.Y8.:X4.Y4.;\n"
    "X8.Y-8.:X4.Y-4.;\nX-8.Y-8.:X-4.Y-4.;\nX-8.Y0:X-4.Y0;\nX-30.Y0:X-30.Y0;\nG60;\nM02;\n";

/// Highest and lowest point of the wire's path in its two planes.
std::pair<double, double> planesOf(const Result<RunResult>& made) {
  EXPECT_TRUE(made.ok()) << made.error().message;
  if (!made.ok() || made->setups[0].interpreted.path.wires.empty()) return {};
  const WireSweep& wire = made->setups[0].interpreted.path.wires.front();
  return {wire.z_low, wire.z_high};
}

std::vector<std::string> heightWarnings(const Result<RunResult>& made) {
  std::vector<std::string> out;
  for (const Diagnostic& d : made->setups[0].interpreted.path.diagnostics.all()) {
    if (d.code == "wedm-heights") out.push_back(d.message);
  }
  return out;
}

TEST(WireRuns, HeightsOfThePlanesAreThoseOfTheStock) {
  for (const auto& [low, high] : {std::pair{0.0, 30.0}, {-12.5, 5.0}, {3.0, 15.0}}) {
    Job job = plateJob();
    job.stock = BoxShape{{-20, -20, low}, {20, 20, high}};
    job.part_point = Vec3(0, 0, 0.5 * (low + high));
    const Result<RunResult> made = run(job, kTwoShapes);
    EXPECT_EQ(planesOf(made), std::pair(low, high));
    EXPECT_TRUE(heightWarnings(made).empty());
  }
}

TEST(WireRuns, HeightsThatAreNotThoseOfTheStockAreTold) {
  Job job = plateJob();
  job.settings.parameters = {{"T", 30}};
  Result<RunResult> made = run(job, kTwoShapes);
  EXPECT_EQ(planesOf(made), std::pair(0.0, 30.0)) << "the job's counts";
  ASSERT_EQ(heightWarnings(made).size(), 1u);
  EXPECT_TRUE(has(heightWarnings(made)[0], "T is 30 mm in a plate of 20 mm")) << heightWarnings(made)[0];
  job.settings.parameters = {{"T", 20}, {"ZB", -5}};
  made = run(job, kTwoShapes);
  ASSERT_EQ(heightWarnings(made).size(), 1u);
  EXPECT_TRUE(has(heightWarnings(made)[0], "ZB is -5 mm where the bottom of the plate is at 0"))
      << heightWarnings(made)[0];
  job.settings.parameters = {{"T", 20}, {"ZB", 0}};
  EXPECT_TRUE(heightWarnings(run(job, kTwoShapes)).empty());
}

TEST(WireRuns, ThePartOfATaperThatChangesOnTheSpot) {
  Job job = plateJob();
  job.stock = BoxShape{{-5, -5, 0}, {15, 15, 20}};
  job.start_holes = {{{2, 3}, 1.0}};
  job.tools[0].diameter = 0.02;
  job.tools[0].spark_gap = 0.0;
  const Result<RunResult> made =
      run(job,
          "T84 T86;\nC001;\nG90 G92 X2. Y3.;\nG52 A0 G41 H000 G01 X2. Y0;\nG52 A0 X5.;\nG52 A5. X10.;\n"
          "G52 A0 Y10.;\nX0;\nY0;\nX2.;\nM00;\nG40 G50 A0 Y3.;\nM02;\n");
  ASSERT_TRUE(made.ok()) << made.error().message;
  // The hole: 10 x 10 and a wedge of 5 mm, whose section grows with the height; half a kerf beside its
  // contour.
  const double lean = 20.0 * std::tan(degToRad(5.0)), wedge = 5.0 * lean / 2.0 * 20.0;
  const double contour = 20.0 * (40.0 + lean);
  const double hole = 2000.0 + wedge + 0.01 * contour;
  EXPECT_NEAR(made->setups[0].bodies.at(0).volume_mm3, 8000.0 - hole, 0.02);
}

}  // namespace
}  // namespace proveout

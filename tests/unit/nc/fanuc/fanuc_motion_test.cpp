// Motion of Fanuc-like mills: rapids, lines, arcs, spirals, chamfers and corners (rows fan-3-*).
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;
using Keys = std::map<std::string, double>;

IsoRun moveRun(const std::string& text, Keys parameters = {}) {
  return {ControlId::kFanucMill, "O1\nG21 G90 G17 F100.\n" + text + "\nM30\n",
          runAtZero(std::move(parameters))};
}
bool notes(const IsoRun& run, const std::string& part) {
  for (const Diagnostic& d : run.path.diagnostics.all()) {
    if (d.severity == Severity::kNote && d.message.find(part) != std::string::npos) return true;
  }
  return false;
}

// fan-3-G00: acceptance 10
/// As if the job had not told how rapids go.
const Keys kAxisByAxis{{"rapid", -1.0}};

TEST(FanucMotion, RapidsGoAxisByAxis) {
  const IsoRun run = moveRun("G0 X30. Y10.", kAxisByAxis);
  EXPECT_EQ(run.motions(), (Lines{"R 10 10 0", "R 30 10 0"}));
  EXPECT_TRUE(notes(run, "setting rapid"));
  EXPECT_EQ(moveRun("G0 X30. Y10.", {{"rapid", 1.0}}).motions(), (Lines{"R 30 10 0"}));
  EXPECT_EQ(moveRun("G0 X5. Y-10. Z20.", kAxisByAxis).motions(),
            (Lines{"R 5 -5 5", "R 5 -10 10", "R 5 -10 20"}));
  EXPECT_EQ(moveRun("G0 X10. Y10.", kAxisByAxis).motions(), (Lines{"R 10 10 0"}));
  EXPECT_FALSE(notes(moveRun("G0 X10. Y10.\nX5.", kAxisByAxis), "rapid"));
  // An axis at half the rate arrives behind the other one.
  ControlSettings settings = runAtZero(kAxisByAxis);
  settings.rapid_mm_min = {10000.0, 5000.0, 10000.0};
  const IsoRun rates(ControlId::kFanucMill, "O1\nG90 G0 X30. Y20.\nM30\n", settings);
  EXPECT_EQ(rates.motions(), (Lines{"R 30 15 0", "R 30 20 0"}));
  double time = 0.0;
  for (const Motion& m : rates.path.motions) time += m.time_s;
  EXPECT_NEAR(time, 60.0 * 20.0 / 5000.0, 1e-9);
}

// fan-3-G01
TEST(FanucMotion, LinesGoByFeed) {
  const IsoRun run = moveRun("G1 X30. Y40. F500.\nZ-5.");
  EXPECT_EQ(run.motions(), (Lines{"F 30 40 0", "F 30 40 -5"}));
  EXPECT_EQ(run.path.motions[0].feed, 500.0);
  EXPECT_NEAR(run.path.motions[0].time_s, 6.0, 1e-9);
}

struct ArcCase {
  const char* text;
  Lines motions;
};

// fan-3-G02 fan-3-G03 fan-3-arcR fan-3-fullcircle fan-3-helix: acceptance 3 to 7
TEST(FanucMotion, Arcs) {
  for (const ArcCase& arc : {
           ArcCase{"G2 X10. Y0 R5.", {"A 10 0 0 c 5 0 0 -180"}},
           ArcCase{"G2 X10. Y0 R6.", {"A 10 0 0 c 5 -3.3166 0 -112.8854"}},
           ArcCase{"G2 X10. Y0 R-6.", {"A 10 0 0 c 5 3.3166 0 -247.1146"}},
           ArcCase{"G3 X10. Y0 R6.", {"A 10 0 0 c 5 3.3166 0 112.8854"}},
           ArcCase{"G3 X10. Y0 R-6.", {"A 10 0 0 c 5 -3.3166 0 247.1146"}},
           ArcCase{"G2 X10. R4.996", {"A 10 0 0 c 5 0 0 -180"}},
           ArcCase{"G3 I10.", {"A 0 0 0 c 10 0 0 360"}},
           ArcCase{"G2 J-4.", {"A 0 0 0 c 0 -4 0 -360"}},
           ArcCase{"G3 X0 Y0 I10.", {"A 0 0 0 c 10 0 0 360"}},
           ArcCase{"G2 X10. I5.004", {"A 10 0 0 c 5.004 0 0 -180"}},
           ArcCase{"G18 G2 X10. Z0 I5. K0", {"A 10 0 0 c 5 0 0 -180"}},
           ArcCase{"G19 G3 Y10. Z0 J5.", {"A 0 10 0 c 0 5 0 180"}},
           ArcCase{"G3 X0 Y20. I0 J10. R10.", {"A 0 20 0 c 0 10 0 180"}},  // R counts
           ArcCase{"G2 X10. Y0 I5. K0", {"A 10 0 0 c 5 0 0 -180"}},        // K0 across the plane is no word
           ArcCase{"G3 X10. Y0 Z-5. I5.", {"A 10 0 -5 c 5 0 0 180"}},
           ArcCase{"G3 I-10. Z-5.", {"A 0 0 -5 c -10 0 0 360"}},
           ArcCase{"G91 G3 X5. Y5. R5.", {"A 5 5 0 c 0 5 0 90"}},
           ArcCase{"G20 G2 X.5 Y0 I.25", {"A 12.7 0 0 c 6.35 0 0 -180"}},
       }) {
    const IsoRun run = moveRun(arc.text);
    EXPECT_EQ(run.error(), "") << arc.text << ": " << run.message();
    EXPECT_EQ(run.motions(), arc.motions) << arc.text;
  }
}

// The side that an arc of G18 goes by: it passes X5 Z-5 (seen from +Y, Z to the right, X up).
TEST(FanucMotion, AnArcOfTheZxPlaneTurnsAsSeenFromY) {
  const IsoRun run = moveRun("G18 G2 X10. Z0 I5. K0");
  ASSERT_EQ(run.path.arcs.size(), 1u);
  const ArcGeometry& arc = run.path.arcs[0];
  const Vec3 u = run.path.motions[0].from - arc.center;
  const Vec3 middle =
      arc.center + std::cos(0.5 * arc.sweep_rad) * u + std::sin(0.5 * arc.sweep_rad) * arc.normal.cross(u);
  EXPECT_NEAR((middle - Vec3(5.0, 0.0, -5.0)).norm(), 0.0, 1e-9);
}

// fan-3-arctol fan-3-arcmissing: acceptance 4, 6
TEST(FanucMotion, ArcsThatAreNoneHaveAlarms) {
  for (const auto& [text, code] : std::vector<std::pair<const char*, const char*>>{
           {"G2 X10. R4.9", "fanuc-020"},
           {"G2 X10. I5.02", "fanuc-020"},
           {"G2 X10. Y5.", "fanuc-022"},
           {"G2 X10. Y0 I5. K3.", "fanuc-021"},
           {"G18 G2 X10. Z0 J5.", "fanuc-021"},
           {"G2 X10. Y0 I5. L2", "fanuc-009"},
           {"G2 X10. Y0 I0 J0", "fanuc-020"},
       }) {
    EXPECT_EQ(moveRun(text).error(), code) << text << ": " << moveRun(text).message();
  }
  // The tolerance is a setting; 0 checks nothing.
  EXPECT_EQ(moveRun("G2 X10. I5.02", {{"arc_radius_tolerance", 0.1}}).error(), "");
  EXPECT_EQ(moveRun("G2 X10. I5.5", {{"arc_radius_tolerance", 0.0}}).error(), "");
  EXPECT_TRUE(notes(moveRun("G2 X10. I5.004"), "setting arc_radius_tolerance"));
  EXPECT_FALSE(notes(moveRun("G2 X10. I5."), "arc_radius_tolerance"));
  // R with the end where the start is: no motion.
  const IsoRun still = moveRun("G2 X0 Y0 R5.\nG1 X1.");
  EXPECT_EQ(still.motions(), (Lines{"F 1 0 0"}));
  EXPECT_FALSE(still.path.diagnostics.all().empty());
}

/// A point of a motion in the plane X-Y, on arcs with the radius going evenly with the angle.
Vec3 pointOf(const IsoRun& run, const Motion& m, double t) {
  if (m.arc < 0) return m.from + t * (m.to - m.from);
  const ArcGeometry& arc = run.path.arcs[static_cast<std::size_t>(m.arc)];
  const Vec3 a = m.from - arc.center, b = m.to - arc.center;
  const double radius = a.norm() + t * (b.norm() - a.norm());
  const double angle = std::atan2(a.y(), a.x()) + t * arc.sweep_rad * arc.normal.z();
  return arc.center + Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.0);
}

// fan-3-spiral: the example of section 3; end, Q, L: two are enough
TEST(FanucMotion, SpiralsAndCones) {
  const std::string at = "G1 X20.\n";
  for (const char* text :
       {"G3 X30. Y0 I-20. J0 Q5. L2", "G3 I-20. J0 Q5. L2", "G3 X30. Y0 I-20. Q5.", "G3 X30. Y0 I-20. L2"}) {
    const IsoRun run = moveRun(at + text);
    ASSERT_EQ(run.error(), "") << text << ": " << run.message();
    EXPECT_NEAR((run.end() - Vec3(30.0, 0.0, 0.0)).norm(), 0.0, 1e-6) << text;
    // It passes (0, 21.25) after a quarter and (25, 0) after a turn.
    double quarter = 1e9, turn = 1e9;
    for (const Motion& m : run.path.motions) {
      for (int k = 0; k <= 1000; ++k) {
        const Vec3 p = pointOf(run, m, 0.001 * k);
        quarter = std::min(quarter, (p - Vec3(0.0, 21.25, 0.0)).norm());
        turn = std::min(turn, (p - Vec3(25.0, 0.0, 0.0)).norm());
      }
    }
    EXPECT_LT(quarter, 0.05) << text;
    EXPECT_LT(turn, 0.05) << text;
  }
  const IsoRun part = moveRun(at + "G3 X0 Y26.25 I-20. Q5. L2");
  EXPECT_EQ(part.error(), "") << part.message();
  const IsoRun cone = moveRun(at + "G2 I-20. Q-5. L2 K-3.");
  EXPECT_EQ(cone.error(), "") << cone.message();
  EXPECT_NEAR((cone.end() - Vec3(10.0, 0.0, -6.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((moveRun(at + "G2 X10. Y0 Z-6. I-20. Q-5. L2").end() - Vec3(10.0, 0.0, -6.0)).norm(), 0.0,
              1e-6);
  EXPECT_EQ(moveRun(at + "G3 X31. Y0 I-20. Q5. L2").error(), "fanuc-5123");
  EXPECT_EQ(moveRun(at + "G3 I-20. Q5.").error(), "fanuc-5123");
  EXPECT_EQ(moveRun(at + "G2 I-20. Q-50. L2").error(), "fanuc-5123");
  EXPECT_EQ(moveRun(at + "G3 I-20. Q5. L99999").error(), "fanuc-003");
}

// fan-3-chamfer fan-3-corner: acceptance 8, 9
TEST(FanucMotion, ChamfersAndCorners) {
  EXPECT_EQ(moveRun("G1 X20. ,R5.\nY20.").motions(),
            (Lines{"F 15 0 0", "A 20 5 0 c 15 5 0 90", "F 20 20 0"}));
  EXPECT_EQ(moveRun("G1 X20. ,C2.\nY20.").motions(), (Lines{"F 18 0 0", "F 20 2 0", "F 20 20 0"}));
  // 120 deg turn: t = R tan 60
  const IsoRun sharp = moveRun("G1 X20. ,R2.\nX10. Y[10.*TAN[60.]]");
  EXPECT_EQ(sharp.motions().front(), "F 16.5359 0 0");
  // Behind a block with functions only the next motion counts.
  EXPECT_EQ(moveRun("G1 X20. ,C2.\nM8\nY20.").motions(), (Lines{"F 18 0 0", "F 20 2 0", "F 20 20 0"}));
  // A line and an arc that leaves at a right angle: the round touches both.
  const IsoRun arc = moveRun("G1 X20. ,R2.\nG3 X30. Y10. I10.");
  EXPECT_EQ(arc.error(), "") << arc.message();
  EXPECT_EQ(arc.motions().size(), 3u);
}

// fan-3-cornererr
TEST(FanucMotion, ChamfersThatDoNotFitHaveAlarms) {
  for (const auto& [text, code] : std::vector<std::pair<const char*, const char*>>{
           {"G1 X20. ,R25.\nY20.", "fanuc-055"},
           {"G1 X20. ,C25.\nY20.", "fanuc-055"},
           {"G1 X20. ,R5.", "fanuc-051"},
           {"G1 X20. ,C5.\nM5", "fanuc-051"},
           {"G1 X20. ,R5.\nG0 Y20.", "fanuc-052"},
           {"G1 X20. ,R5.\nG28 Y20.", "fanuc-051"},
           {"G1 X20. ,R5. ,C2.\nY20.", "fanuc-053"},
           {"G1 X20. ,R-5.\nY20.", "fanuc-003"},
       }) {
    EXPECT_EQ(moveRun(text).error(), code) << text << ": " << moveRun(text).message();
  }
}

// fan-3-G33
TEST(FanucMotion, ThreadsOfMills) {
  const IsoRun run = moveRun("S500 M3\nG33 Z-20. F1.5 Q90000\nG0 X5.");
  EXPECT_EQ(run.error(), "") << run.message();
  EXPECT_EQ(run.motions(), (Lines{"T 0 0 -20", "R 5 0 -20"}));
  EXPECT_NEAR(run.path.motions[0].feed, 750.0, 1e-9);
  EXPECT_NEAR(run.path.motions[0].time_s, 60.0 * 20.0 / 750.0, 1e-9);
  bool told = false;
  for (const auto& e : run.path.events) {
    if (const auto* thread = e.event.as<event::Thread>()) {
      told = true;
      EXPECT_EQ(thread->lead, 1.5);
      EXPECT_EQ(thread->angle_deg, 90.0);
    }
  }
  EXPECT_TRUE(told);
  // The lead counts along the longer axis.
  EXPECT_NEAR(moveRun("S500 M3\nG33 X3. Z-4. F1.").path.motions[0].feed, 625.0, 1e-9);
  EXPECT_EQ(moveRun("S500 M3\nG33 Z-20. F1.5 Q90.").error(), "fanuc-007");
}

// fan-3-G31 fan-3-G31P
TEST(FanucMotion, SkipsWithoutAContactReachTheirEnd) {
  for (const char* text : {"G31 X50. F100.", "G31 P1 X50.", "G31 P4 X50.", "G91 G31 X50."}) {
    const IsoRun run = moveRun(text);
    EXPECT_EQ(run.error(), "") << text << ": " << run.message();
    EXPECT_EQ(run.end().x(), 50.0) << text;
    EXPECT_EQ(run.path.motions[0].kind, MotionKind::kProbe) << text;
  }
  EXPECT_EQ(moveRun("G31 X50.\n#1=#5061\nG1 Y#1").end().y(), 50.0);
  EXPECT_EQ(moveRun("G41 D1 G1 X5.\nG31 X50.").error(), "fanuc-035");
  EXPECT_EQ(moveRun("G68 X0 Y0 R90.\nG31 X50.").error(), "");
}

// fan-3-G60
TEST(FanucMotion, OneDirectionOverrunsAndComesBack) {
  EXPECT_EQ(moveRun("G60 X10.", {{"g60_overrun.1", -2.0}}).motions(), (Lines{"R 8 0 0", "R 10 0 0"}));
  EXPECT_EQ(moveRun("G60 X10. Y10.", {{"g60_overrun.1", 2.0}, {"rapid", 1.0}}).motions(),
            (Lines{"R 12 10 0", "R 10 10 0"}));
  const IsoRun plain = moveRun("G60 X10.");
  EXPECT_EQ(plain.motions(), (Lines{"R 10 0 0"}));
  EXPECT_TRUE(notes(plain, "g60_overrun"));
}

// fan-3-G09 fan-3-G61 fan-3-G62 fan-3-G63 fan-3-G64 fan-3-G05.1 fan-3-G08 fan-3-G05P fan-3-G10.6
TEST(FanucMotion, CodesOfSpeedLeaveThePath) {
  for (const char* code : {"G9", "G61", "G62", "G63", "G64", "G05.1 Q1", "G05.1 Q0", "G08 P1", "G08 P0",
                           "G05 P10000", "G05 P0", "G10.6", "G4", "M48", "M49"}) {
    const IsoRun run = moveRun(std::string(code) + "\nG1 X5.\nY5.");
    EXPECT_EQ(run.error(), "") << code << ": " << run.message();
    EXPECT_EQ(run.motions(), (Lines{"F 5 0 0", "F 5 5 0"})) << code;
  }
  EXPECT_TRUE(notes(moveRun("G10.6"), "G10.6"));
  EXPECT_EQ(moveRun("G9 G1 X5.\nG61 Y5.").motions(), (Lines{"F 5 0 0", "F 5 5 0"}));
}

}  // namespace
}  // namespace proveout::test

// The language of the wire EDM control: units, modes, errors and times. A test names the rows of coverage
// that it proves.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "wedm_path.h"

namespace proveout {
namespace {

using test::WedmPath;

constexpr const char* kBefore = "T84 T86; C001; G90 G92 X0 Y0 U0 V0;\n";

void expectWay(const std::string& blocks, const std::vector<Vec2>& wanted) {
  const WedmPath run(kBefore + blocks + "\nM02;\n");
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  const std::vector<Vec2> got = run.ends();
  ASSERT_EQ(got.size(), wanted.size()) << blocks;
  for (std::size_t k = 0; k < got.size(); ++k) EXPECT_LT((got[k] - wanted[k]).norm(), 1e-9) << blocks << k;
}

/// A block, and the code of the error that it is.
struct BadBlock {
  const char* text;
  const char* code;
};
class WedmBadBlocks : public testing::TestWithParam<BadBlock> {};

TEST_P(WedmBadBlocks, AreErrorsWithAPlace) {
  const WedmPath run(kBefore + std::string(GetParam().text) + "\nM02;\n");
  EXPECT_EQ(run.error(), GetParam().code);
  const Diagnostic d = run.first(Severity::kError);
  EXPECT_GE(d.where.line, 2);
  EXPECT_GE(d.where.column, 1);
  EXPECT_EQ(d.where.file, "main.nc");
}

// K24. Rows: wedm-1.2-Z wedm-2.2-onemotion wedm-2.2-dupaxis wedm-5.1-space wedm-5.3-IJ wedm-5.9-excl
// wedm-5.9.1-excl wedm-5.6.2-startup wedm-5.6.4-cancel wedm-7.2-start wedm-1.4-ranges wedm-9-C
// wedm-1.1-charset
INSTANTIATE_TEST_SUITE_P(
    Language, WedmBadBlocks,
    testing::Values(
        BadBlock{"C1;", "wedm-syntax"}, BadBlock{"X 10.;", "wedm-syntax"}, BadBlock{"XA10.;", "wedm-syntax"},
        BadBlock{"G01 X1. X2.;", "wedm-2.2-dupaxis"}, BadBlock{"G00 X1. G01 Y1.;", "wedm-2.2-onemotion"},
        BadBlock{"G01 Z1.;", "wedm-syntax"}, BadBlock{"G01 X1. /;", "wedm-syntax"},
        BadBlock{"G01 X1.#;", "wedm-syntax"}, BadBlock{"\xC3\xA4;", "wedm-syntax"},
        BadBlock{"H1=3;", "wedm-syntax"}, BadBlock{"G04;", "wedm-syntax"},
        BadBlock{"G31 Y1.;", "wedm-syntax"}, BadBlock{"G01 X1.2.3;", "wedm-syntax"},
        BadBlock{"X;", "wedm-syntax"}, BadBlock{"G07;", "wedm-13-code"}, BadBlock{"M03;", "wedm-13-code"},
        BadBlock{"T01;", "wedm-13-code"}, BadBlock{"M00 M02;", "wedm-2.2-twice"},
        BadBlock{"G41 G42 H001;", "wedm-2.2-twice"}, BadBlock{"H001;", "wedm-5.6.1-H"},
        BadBlock{"G01 X1000.;", "wedm-1.4-ranges"}, BadBlock{"G01 X1. R1000.;", "wedm-1.4-ranges"},
        BadBlock{"G02 X1. I100000.;", "wedm-1.4-ranges"}, BadBlock{"C000;", "wedm-9-C"},
        BadBlock{"C101;", "wedm-9-C"}, BadBlock{"A2.;", "wedm-5.7-A"}, BadBlock{"G51 A45.;", "wedm-5.7-A"},
        BadBlock{"G51 A2000;", "wedm-5.7-A"}, BadBlock{"G02 X1. Y1.;", "wedm-5.3-IJ"},
        BadBlock{"G01 X1. I1.;", "wedm-5.3-IJ"}, BadBlock{"G02 X3. I1.;", "wedm-5.3-radius"},
        BadBlock{"G02 X0 I0 J0;", "wedm-5.3-radius"}, BadBlock{"G02 X2. I1. U1.;", "wedm-6-UV"},
        BadBlock{"G01 X1. : X2.;", "wedm-5.9-colon"}, BadBlock{"G61; G74;", "wedm-5.9-excl"},
        BadBlock{"G61; G51 A1.;", "wedm-5.9-excl"}, BadBlock{"G61; G01 X1. U1.;", "wedm-5.9-words"},
        BadBlock{"G61; G01 X1. : G28 X1.;", "wedm-5.9-colon"},
        BadBlock{"G74; G02 X2. I1.;", "wedm-5.9.1-excl"}, BadBlock{"G74; G61;", "wedm-5.9-excl"},
        BadBlock{"G74; G52 A1.;", "wedm-5.9.1-excl"}, BadBlock{"G02; G74; X2. I1.;", "wedm-5.9.1-excl"},
        BadBlock{"H001=1.; G74; G41 H001;", "wedm-5.9.1-offset"},
        BadBlock{"H001=1.; G41 H001; G54; G55;", "wedm-5.6-frame"},
        BadBlock{"H001=.1; G41 H001 G02 X2. I1.; G01 X5.;", "wedm-5.6.2-startup"},
        BadBlock{"H001=.1; G41 H001 G01 X2.; X4.; G40 G02 X6. I1.;", "wedm-5.6.4-cancel"},
        BadBlock{"H001=.1; G41 H001 G01 X2.; X4.; G42 G02 X6. I1.; G01 X9.;", "wedm-5.6.5-change"},
        BadBlock{"H001=.1; G41 H001 G00 X2.; G01 X4.;", "wedm-5.6.2-rapid"},
        BadBlock{"G51 A2. G02 X2. I1.; G01 X5.;", "wedm-7.2-start"},
        BadBlock{"G51 A2. G01 X2.; X4.; G50 G02 X6. I1.;", "wedm-7.2-start"},
        BadBlock{"G01 U1.; G51 A2. X4.;", "wedm-7.2-lean"}, BadBlock{"M98;", "wedm-10-P"},
        BadBlock{"M98 P0009;", "wedm-10-P"}, BadBlock{"M98 P0009 X1.;", "wedm-8.3-M98"},
        BadBlock{"P0001;", "wedm-10-P"}, BadBlock{"M99;", "wedm-8.4-M99"},
        BadBlock{"M98 P1 L1000;", "wedm-syntax"}, BadBlock{"M50; G01 X1.;", "wedm-8.5-M50"},
        BadBlock{"R1.;", "wedm-14-R"}, BadBlock{"G41 H000 G01 X5. R9.; Y1.;", "wedm-14-R"},
        BadBlock{"G51 A0 G01 X5.; G51 A3. G03 X10. Y5. J5.; G50 G01 X20.;", "wedm-7.5-error"},
        BadBlock{"H001=1.2; G41 H001 G01 X5.; G03 X5. J1.; G40 G01 X9.;", "wedm-5.6.7-overcut"},
        BadBlock{"G52 A3. G01 X5.; X10.; X0 Y.5; G50 X-9.;", "wedm-7.3-joins"},
        BadBlock{"G51 A1.; G92 X0;", "wedm-5.11-taper"}));

// Row: wedm-2.1-block
TEST(WedmLanguage, ABadBlockChangesNothing) {
  ControlSettings settings;
  settings.max_errors = 5;
  const WedmPath run(kBefore + std::string("G01 X1.; G91 G20 H001=5. X5. Q7; X3.; G01 XH001 M02;"), settings);
  ASSERT_EQ(run.count(), 3u);
  EXPECT_EQ(run.ends()[1], Vec2(3, 0)) << "still G90, G21";
  EXPECT_EQ(run.ends()[2], Vec2(0, 0)) << "H001 has no value";
  EXPECT_EQ(run.summary.errors, 1);
}

// K21, K22. Rows: wedm-5.4-G05 wedm-5.4-G06 wedm-5.4-G08 wedm-5.4-G09
TEST(WedmLanguage, MirrorAndChangeOfPlaces) {
  struct Case {
    const char* codes;
    Vec2 line, center, arc;
    bool counter_clockwise;
  };
  for (const Case& c :
       {Case{"G05", {-10, 5}, {-20, 5}, {-20, 15}, true}, Case{"G06", {10, -5}, {20, -5}, {20, -15}, true},
        Case{"G05; G06", {-10, -5}, {-20, -5}, {-20, -15}, false},
        Case{"G08", {5, 10}, {5, 20}, {15, 20}, true}, Case{"G05; G09", {10, 5}, {20, 5}, {20, 15}, false}}) {
    const WedmPath run(kBefore + std::string(c.codes) + "; G01 X10. Y5.; G02 X20. Y15. I10.; M02;");
    ASSERT_EQ(run.count(), 2u) << c.codes;
    EXPECT_LT((run.ends()[0] - c.line).norm(), 1e-9) << c.codes;
    EXPECT_LT((run.ends()[1] - c.arc).norm(), 1e-9) << c.codes;
    EXPECT_LT((run.wire(1).lower.center - c.center).norm(), 1e-9) << c.codes;
    EXPECT_EQ(run.wire(1).lower.sweep_rad > 0, c.counter_clockwise) << c.codes;
  }
}

// K23. Rows: wedm-5.5.1-G20 wedm-5.5.1-G21 wedm-1.4-units
TEST(WedmLanguage, InchAndMillimetre) {
  expectWay("G20; G01 X10000; G21 Y1000; Y2.;", {{25.4, 0}, {25.4, 1}, {25.4, 2}});
  expectWay("G20; G01 X1.;", {{25.4, 0}});
  expectWay("G00 X100 Y100;", {{0.1, 0.1}});
}

// K25. Rows: wedm-8.3-M98 wedm-8.4-M99 wedm-10-L wedm-10-P wedm-10-nest
TEST(WedmLanguage, Subprograms) {
  const auto run = [](const std::string& call, const std::string& subs) {
    return WedmPath(kBefore + call + " M02;\n" + subs);
  };
  EXPECT_EQ(run("M98 P0001 L0;", "N0001; G91 G01 X1.; M99;").count(), 0u);
  EXPECT_EQ(run("M98 P0001 L3;", "N0001; G91 G01 X1.; M99;").count(), 3u);
  EXPECT_EQ(run("M98 P1;", "N0001; G91 G01 X1.; M98 P0002 L2; M99; N0002; Y1.; M99;").ends().back(),
            Vec2(1, 2));
  std::string chain;
  for (int k = 1; k <= 10; ++k)
    chain += "N000" + std::to_string(k % 10) + "; M98 P000" + std::to_string((k + 1) % 10) + "; M99;\n";
  EXPECT_EQ(run("M98 P0001;", chain).error(), "wedm-10-nest");
  EXPECT_EQ(run("M98 P0001;", "N0001; G01 X1.;").error(), "wedm-8.4-M99") << "no end";
  const WedmPath nine = run("M98 P0001;",
                            "N0001;M98P2;M99;N2;M98P3;M99;N3;M98P4;M99;N4;M98P5;M99;N5;M98P6;M99;"
                            "N6;M98P7;M99;N7;M98P8;M99;N8;M98P9;M99;N9;G01X1.;M99;");
  EXPECT_EQ(nine.error(), "");
  EXPECT_EQ(nine.path.motions.at(0).source.depth, 9);
}

TEST(WedmLanguage, LoopsOfEmptySubprogramsEnd) {
  ControlSettings settings;
  settings.block_limit = 10'000;
  std::string subs;
  for (int k = 1; k <= 8; ++k)
    subs += "N" + std::to_string(k) + ";M98 P" + std::to_string(k + 1) + " L999;M99;";
  const WedmPath run(kBefore + std::string("M98 P1 L999; M02;") + subs + "N9;M99;", settings);
  EXPECT_EQ(run.summary.end, ProgramEnd::kBlockLimit);
  EXPECT_EQ(run.error(), "wedm-endless-loop");
}

TEST(WedmLanguage, LoopsOfBlocksThatDoNothingEnd) {
  ControlSettings settings;
  settings.block_limit = 10'000;
  std::string blanks;
  for (int k = 0; k < 1000; ++k) blanks += ";";
  const WedmPath run(kBefore + std::string("M98 P1 L999; M02; N1;") + blanks + "M99;", settings);
  EXPECT_EQ(run.error(), "wedm-block-limit");
}

// Rows: wedm-9-C wedm-5-G04 wedm-5.5.4-G34 wedm-5.5.4-G35 wedm-5.5.5-G37T wedm-5.2-G01
TEST(WedmLanguage, Times) {
  ControlSettings settings;
  settings.parameters = {{"FEED.2", 6}, {"AREA.3", 60}, {"T", 20}, {"SLOW", 0.5}, {"ABSENT.9", 1}};
  const WedmPath run("G92X0Y0;C002;G01X6.;C003;X12.;G04X1.5;G04X250;G34X18.;G35X24.;M02;", settings);
  ASSERT_EQ(run.count(), 4u);
  EXPECT_NEAR(run.path.motions[0].time_s, 60.0, 1e-9);
  EXPECT_NEAR(run.path.motions[1].time_s, 120.0, 1e-9) << "60 mm2/min through 20 mm";
  EXPECT_NEAR(run.path.motions[2].time_s, 180.0, 1e-9) << "half the speed in the last 3 mm";
  EXPECT_NEAR(run.path.motions[3].time_s, 120.0, 1e-9);
  EXPECT_NEAR(run.summary.cycle_s, 60 + 120 + 1.75 + 180 + 120, 1e-9);
  EXPECT_NEAR(run.path.motions[1].feed, 3.0, 1e-12);
  EXPECT_EQ(WedmPath("G92X0Y0;C009;M02;", settings).error(), "wedm-9-C");
  const WedmPath dwell("G92X0Y0;H001=.1;G41H001G01X1.;G37X50T2.;X5.;Y5.;X6.;G36;G40X9.;M02;");
  EXPECT_NEAR(dwell.summary.cycle_s - dwell.summary.cutting_s, 2 * 2 * 2.0, 1e-9)
      << "two corners, before and during";
}

// Rows: wedm-8.2-M02 wedm-8.1-M00 wedm-8.5-M50 wedm-8.6-M60 wedm-15-T84 wedm-15-T85 wedm-15-T86 wedm-15-T87
TEST(WedmLanguage, FunctionsAreEvents) {
  const WedmPath run("T84T86;G92X0Y0;C001;G01X1.;M00;M50;G00X9.;M60;G01X10.;T85T87M02;G01X50.;");
  std::string told;
  for (const Toolpath::EventAt& at : run.path.events) {
    if (const auto* c = at.event.as<event::Coolant>()) told += c->code + (c->on ? "+ " : "- ");
    if (const auto* f = at.event.as<event::Function>()) told += f->code + " ";
    if (const auto* w = at.event.as<event::Wire>()) told += w->code + (w->threaded ? "+ " : "- ");
    if (const auto* s = at.event.as<event::Stop>()) told += s->code + " ";
    if (const auto* e = at.event.as<event::End>()) told += e->code;
  }
  EXPECT_EQ(told, "T84+ T86+ C001 M00 M50- M60+ T85- T87- M02");
  EXPECT_EQ(run.count(), 3u) << "nothing behind M02 is executed";
  EXPECT_FALSE(run.warns("wedm-15-T84"));
  EXPECT_TRUE(WedmPath("G92X0Y0;G01X1.;M02;").warns("wedm-15-T84"));
}

// Rows: wedm-8.1-M00 wedm-8.5-M50 wedm-8.6-M60 wedm-9-C wedm-15-T84 wedm-15-T85 wedm-15-T86 wedm-15-T87
TEST(WedmLanguage, MotionsTellTheStateOfTheWire) {
  const WedmPath run(
      "G92X0Y0;G01X1.;T84;X2.;T86C001;X3.;M50;G00X4.;M60;X5.;M00;X6.;X7.;G01X8.;G00X9.;T87;G01X10.M00;G00X11."
      ";"
      "M00;M60;X12.;T85;G01X13.;M02;");
  std::string told;
  for (std::size_t k = 0; k < run.count(); ++k) {
    const WireState& s = run.wire(k).state;
    told += s.threaded ? "" : "off";
    told += s.by_hand ? "hand" : "";
    told += std::string(s.runs ? "r" : "") + (s.fluid ? "f" : "") + (s.condition ? "c " : " ");
  }
  EXPECT_EQ(told, " f rfc offrfc rfc handrfc handrfc rfc rfc fc handfc fc c ");
  EXPECT_TRUE(run.wire(2).state.runs && run.wire(2).state.fluid && run.wire(2).state.condition);
  EXPECT_FALSE(run.wire(1).state.runs && run.wire(1).state.fluid && run.wire(1).state.condition);
}

// Rows: wedm-5.6-G40 wedm-5.6-G41 wedm-5.6.4-H0
TEST(WedmLanguage, MotionsTellWhetherAnOffsetIsOn) {
  const WedmPath run("T84T86;C001;H001=.1;G92X0Y0;G01X1.;G41H001X2.;X5.;Y5.;G40X9.;G41H000X12.;M02;");
  std::string told;
  for (const Motion& motion : run.path.motions) told += motion.compensated ? "1" : "0";
  EXPECT_EQ(told, "011100") << "the start-up with it, the cancel without";
}

// Rows: wedm-13-init wedm-5.5.3-G31X0
TEST(WedmLanguage, PowerOnStateIsThatOfTheManual) {
  // G00, G09, G12, G40, G50, G60, G75, G90, G28, G35, G30, G36, G21, G54.
  const WedmPath run("T84T86;C001;G92X1.Y1.;/X2.;G01X3.Y2.;M02;");
  EXPECT_EQ(run.path.motions[0].kind, MotionKind::kRapid);
  EXPECT_EQ(run.ends()[0], Vec2(2, 1));
  EXPECT_EQ(run.ends()[1], Vec2(3, 2));
  // The built-in corner treatment has no geometry, on or off.
  const WedmPath with("T84T86;C001;G31X0G92X1.Y1.;G37X0;G01X3.Y2.;X5.;M02;");
  EXPECT_EQ(with.error(), "");
  EXPECT_EQ(with.count(), 2u);
}

// Rows: wedm-1.1-charset wedm-1.6-comment wedm-3-N
TEST(WedmLanguage, SmallLettersCommentsAndNumbers) {
  const WedmPath run("t84t86;c001;g92x0y0(;);n12g1x+1.(one)y-0.5 (two);;\nN0013 y-h001(h); h001=5; m2;");
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  ASSERT_EQ(run.count(), 2u);
  EXPECT_EQ(run.ends()[0], Vec2(1, -0.5));
  EXPECT_EQ(run.path.motions[0].source.block, 12);
  EXPECT_EQ(run.path.motions[1].source.block, 13);
  EXPECT_TRUE(WedmPath("G92X0Y0;X1.\nM02;").warns("wedm-2.1-block"));
}

TEST(WedmLanguage, LeanAndTravelAreLimited) {
  ControlSettings settings;
  settings.parameters = {{"T", 20}, {"MAX_TILT", 5}, {"U_TRAVEL", 10}};
  settings.limits[0] = AxisLimit{-5, 50};
  const std::string head = "T84T86;C001;G92X0Y0;";
  EXPECT_EQ(WedmPath(head + "G51A4.G01X9.;Y9.;G50X20.;M02;", settings).error(), "");
  EXPECT_EQ(WedmPath(head + "G51A6.G01X9.;Y9.;G50X20.;M02;", settings).error(), "wedm-tilt");
  const WedmPath far(head + "G01X60.;M02;", settings);
  const auto told = [](const WedmPath& run) {
    for (const Toolpath::EventAt& at : run.path.events) {
      if (const auto* o = at.event.as<event::Overtravel>()) return o->axis;
    }
    return std::string();
  };
  EXPECT_EQ(told(far), "X");
  settings.parameters["MAX_TILT"] = 0;
  EXPECT_EQ(told(WedmPath(head + "G00U-11.;M02;", settings)), "U");
}

TEST(WedmLanguage, TheMainPlaneMayBeTheUpperOne) {
  ControlSettings settings;
  settings.parameters = {{"T", 20}, {"ZM", 20}, {"ZS", 0}};
  const std::string head = "T84T86;C001;G92X-5.Y0;";
  const WedmPath cone(head + "G52A2.5G01X0;X10.;G03X14.Y4.J4.;G01Y9.;G50X20.;M02;", settings);
  ASSERT_EQ(cone.error(), "") << cone.first(Severity::kError).message;
  const WireSweep& arc = cone.wire(2);
  EXPECT_NEAR((arc.upper.from - arc.upper.center).norm(), 4.0, 1e-9);
  EXPECT_NEAR((arc.lower.from - arc.lower.center).norm(), 4.0 - 20 * std::tan(degToRad(2.5)), 1e-9)
      << "leans to the right going up, outward";
  const WedmPath shapes(head + "G01X0;G61;X5.:X7.;G60;M02;", settings);
  EXPECT_EQ(shapes.ends()[1], Vec2(5, 0));
  EXPECT_EQ(shapes.ends(true)[1], Vec2(7, 0));
  EXPECT_TRUE(shapes.warns("wedm-5.9-G60"));
}

TEST(WedmLanguage, TheJobChoosesWhatTheManualLeavesOpen) {
  ControlSettings settings;
  settings.parameters = {{"G29_TANGENT", 1}, {"TAPER_ARC", 1}, {"H.1", 1}, {"T", 20}};
  const std::string head = "T84T86;C001;G92X0Y-5.;";
  const WedmPath corner(head + "G29G42H001G01Y0;X10.;Y9.;G40X20.;M02;", settings);
  ASSERT_EQ(corner.error(), "");
  const double e = std::tan(kPi / 8);
  EXPECT_LT((corner.ends()[2] - Vec2(10 + e, -1)).norm(), 1e-9);
  EXPECT_LT((corner.ends()[3] - Vec2(11, -e)).norm(), 1e-9);
  const WedmPath taper(head + "G52A3.G01Y0;X10.;Y9.;G50X20.;M02;", settings);
  ASSERT_EQ(taper.error(), "");
  EXPECT_NEAR(taper.wire(2).upper.sweep_rad, kPi / 2, 1e-9);
  EXPECT_EQ(taper.wire(2).lower.from, taper.wire(2).lower.to);
}

TEST(WedmLanguage, BadSettingsAreErrors) {
  const auto error = [](const std::map<std::string, double>& parameters) {
    ControlSettings settings;
    settings.parameters = parameters;
    return WedmPath("M02;", settings).error();
  };
  EXPECT_EQ(error({{"THICKNESS", 1}}), "wedm-parameter");
  EXPECT_EQ(error({{"T", -1}}), "wedm-parameter");
  EXPECT_EQ(error({{"ZM", 5}, {"ZS", 5}}), "wedm-parameter");
  EXPECT_EQ(error({{"ZU", 10}}), "wedm-parameter");
  EXPECT_EQ(error({{"FEED.101", 1}}), "wedm-parameter");
  EXPECT_EQ(error({{"T", 50}}), "");
}

TEST(WedmLanguage, StopsAfterTheBlockThatWasAskedFor) {
  ControlSettings settings;
  settings.until = UntilBlock{{}, 20};
  const WedmPath run("G92X0Y0;N10G01X1.;N20X2.;N30X3.;M02;", settings);
  EXPECT_EQ(run.summary.end, ProgramEnd::kUntil);
  EXPECT_EQ(run.count(), 2u);
}

}  // namespace
}  // namespace proveout

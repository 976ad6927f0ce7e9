// M codes. Texts of errors and figures are those of rs274 2.9.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/nc/linuxcnc/linuxcnc_run.h"

namespace proveout::test {
namespace {

ControlSettings withTexts(std::map<std::string, std::string> texts) {
  ControlSettings settings = runAtZero();
  settings.texts = std::move(texts);
  return settings;
}

constexpr const char* kTools = "T1 P1 Z50 D10 ;first\nT2 P2 Z30 D6\nT3 P3 X10 Z20 D0.8 Q2\n";

/// Codes of events that are functions, stops, coolant and ends.
Lines events(const IsoRun& run) {
  Lines all;
  for (const auto& [before, e] : run.path.events) {
    if (const auto* function = e.as<event::Function>()) all.push_back(function->code);
    if (const auto* stop = e.as<event::Stop>()) all.push_back("stop " + stop->code);
    if (const auto* coolant = e.as<event::Coolant>()) all.push_back(coolant->code);
    if (const auto* end = e.as<event::End>()) all.push_back("end " + end->code);
  }
  return all;
}

std::string messageOf(const std::string& line) { return lcn(line + "\nM2\n").message(); }

// lcn-5-M0 lcn-5-M2
TEST(LinuxCncFunction, StopsAndEnds) {
  EXPECT_EQ(events(lcn("M0\nM60\nG0 X1 M2 Y3\nX5\n")), (Lines{"stop M0", "M60", "end M2"}));
  EXPECT_EQ(lcn("G0 X1 M2 Y3\nX5\n").motions(), (Lines{"R 1 3 0"}));
  EXPECT_EQ(events(lcn("M30\n")), (Lines{"end M30"}));
  EXPECT_EQ(lcn("o1 sub\nG0 X1\nM2\no1 endsub\no1 call\nG0 X2\nM2\n").motions(), (Lines{"R 1 0 0"}));
}

// lcn-5-M3
TEST(LinuxCncFunction, Spindle) {
  EXPECT_EQ(
      told(lcn(
          "S500 M3\n(debug,#<_spindle_on> #<_spindle_cw> #<_rpm>)\nM4 $0\n(debug,#<_spindle_cw>)\nM5 $-1\n"
          "(debug,#<_spindle_on>)\nM2\n")),
      (Lines{"1.000000 1.000000 500.000000", "0.000000", "0.000000"}));
  EXPECT_TRUE(messageOf("M3 $1").starts_with("Spindle ($) number out of range"));
  EXPECT_TRUE(messageOf("G0 X1 $0").starts_with("$ (spindle selection) word with no M3"));
}

// lcn-5-M3 lcn-4-G28.1: S beside P and G92 is a speed alone; G28.1 stands beside a motion.
TEST(LinuxCncFunction, WordsBesideOthers) {
  const IsoRun run =
      lcn("G21 F100\nS500 G64 P0.1\n(debug,#<_rpm>)\nG2 X0 Y0 I3 P2 S200\n(debug,#<_rpm>)\nG0 X3 S700 "
          "G92\nG4 P1 S3\n"
          "(debug,#<_rpm>)\nG28.1 G0 X5\nG28\nM2\n");
  EXPECT_EQ(run.error(), "linuxcnc-axis-words");
  const IsoRun good =
      lcn("G21 F100\nS500 G64 P0.1\n(debug,#<_rpm>)\nG2 X0 Y0 I3 P2 S200\n(debug,#<_rpm>)\nG92 X0 S700\n"
          "(debug,#<_rpm>)\nG28.1 G0 X5\nG28\nM2\n");
  EXPECT_EQ(good.error(), "") << good.message();
  EXPECT_EQ(told(good), (Lines{"500.000000", "200.000000", "700.000000"}));
  EXPECT_EQ(good.motions().back(), "R 0 0 0");
}

// lcn-5-M6 lcn-5-M61
TEST(LinuxCncFunction, Tools) {
  const ControlSettings tools = withTexts({{"tool_table", kTools}});
  const auto run = [&](const std::string& text) { return lcn(text, {}, tools); };
  EXPECT_EQ(
      told(run(
          "T1\nM6\n(debug,#<_current_tool> #<_selected_tool> #5400 #5403 #5410 #5413)\nM6\nT3 M6\n"
          "(debug,#5400 #5401 #5403 #5410 #5413)\nM61 Q2\n(debug,#5400 #5403)\nT0 M6\n(debug,#5400)\nM2\n")),
      (Lines{"1.000000 1.000000 1.000000 50.000000 10.000000 0.000000",
             "3.000000 10.000000 20.000000 0.800000 2.000000", "2.000000 30.000000", "0.000000"}));
  EXPECT_EQ(run("T9\nM2\n").message(), "Requested tool 9 not found in the tool table");
  EXPECT_EQ(run("M61 Q9\nM2\n").message(), "Requested tool 9 not found in the tool table");
  EXPECT_EQ(run("T1.5 M6\nM2\n").message(), "Non integer value for integer");
  EXPECT_EQ(run("T-1 M6\nM2\n").message(), "Negative tool id (tool not found)");
  EXPECT_EQ(messageOf("M61"), "Need non-negative Q-word to specify tool number with M61");
}

// lcn-5-M7
// lcn-5-M6
TEST(LinuxCncFunction, ToolChangesStopTheSpindle) {
  const std::string program = "S100 M3\nT1 M6\nG86 X1 Y1 Z-1 R2 P0\nM2\n";
  EXPECT_EQ(lcn("G21 G90 F100\n" + program).message(), "Spindle not turning in g86");
  EXPECT_EQ(lcn("G21 G90 F100\nT1 M6 M3 S100\nG86 X1 Y1 Z-1 R2 P0\nM2\n").error(), "");
  ControlSettings settings = runAtZero();
  settings.texts["ini"] = "[EMCIO]\nTOOL_CHANGE_WITH_SPINDLE_ON = 1\n";
  EXPECT_EQ(IsoRun(ControlId::kLinuxCnc, "G21 G90 F100\n" + program, settings).error(), "");
}

TEST(LinuxCncFunction, Coolant) {
  EXPECT_EQ(events(lcn("M7\nM8\nM9\n")), (Lines{"M7", "M8", "M9", "end end of text"}));
  EXPECT_EQ(told(lcn("M7\nM8\n(debug,#<_mist> #<_flood>)\nM9\n(debug,#<_mist> #<_flood>)\nM2\n")),
            (Lines{"1.000000 1.000000", "0.000000 0.000000"}));
}

// lcn-5-M19
TEST(LinuxCncFunction, Orients) {
  EXPECT_EQ(events(lcn("M3 S100\nM19 R90 P1 Q2 $0\nM2\n")).front(), "M19 R90");
  EXPECT_EQ(messageOf("M19 R400"), "R value must be within 0..360 with M19");
  EXPECT_EQ(messageOf("M19 R1 P5"), "P value must be 0,1,or 2 with M19");
}

// lcn-5-M48 lcn-5-M62 lcn-5-M100
TEST(LinuxCncFunction, OverridesOutputsAndUserCodes) {
  const IsoRun run = lcn(
      "M48\nM50 P0\nM51\nM52 P1\nM53 P0\nM62 P1 G0 X1\nM67 E1 Q2.5\nM68 E0 Q1\nM64 P2\nM101 P3 Q-4.5\nM2\n");
  EXPECT_EQ(events(run), (Lines{"M48", "M50 P0", "M51", "M52 P1", "M53 P0", "M62 P1", "M67 E1 Q2.5",
                                "M68 E0 Q1", "M64 P2", "M101 P3 Q-4.5", "end M2"}))
      << run.message();
  EXPECT_TRUE(run.tells("linuxcnc-m-function"));
  EXPECT_EQ(run.motions(), (Lines{"R 1 0 0"}));
  EXPECT_EQ(messageOf("M62"), "No valid P word with M62");
  EXPECT_EQ(messageOf("M67 Q1"), "Invalid analog index with M67");
  EXPECT_TRUE(messageOf("M8 P1").starts_with("P word with no G2 G3"));
}

// lcn-5-M66
TEST(LinuxCncFunction, Inputs) {
  const std::string text =
      "M66 P0 L0\n(debug,#5399)\nM66 P1 L3 Q2\n(debug,#5399)\nM66 E2 L0\n(debug,#5399)\nM66 P5 "
      "L0\n(debug,#5399)\n"
      "M66 P0 L4 Q1\n(debug,#5399)\nM2\n";
  const IsoRun run = lcn(text, {}, withTexts({{"inputs.P0", "1"}, {"inputs.P1", "1"}, {"inputs.E2", "2.5"}}));
  EXPECT_EQ(told(run), (Lines{"1.000000", "1.000000", "2.500000", "-1.000000", "-1.000000"}))
      << run.message();
  EXPECT_TRUE(run.tells("linuxcnc-input"));
  EXPECT_EQ(messageOf("M66 L0"), "Need to have either a valid P or a valid E word with M66");
  EXPECT_EQ(messageOf("M66 P0 E1"), "Invalid to select both a digital and an analog input with M66");
  EXPECT_EQ(messageOf("M66 E1 L1 Q1"), "Can't select analog input with wait type != immediate return");
  EXPECT_EQ(messageOf("M66 P1 L3"), "Zero timeout with wait type != immediate return");
}

// lcn-5-M70: whether G92 acts comes back, its shift does not.
TEST(LinuxCncFunctions, SavedStateHoldsWhetherTheShiftActs) {
  const auto end = [](const std::string& text) {
    return lcn("G21 F100\n" + text + "\nG1 X1 Y1 Z1\nM2\n").end();
  };
  EXPECT_EQ(end("M70\nG92 Z24\nM72"), Vec3(1, 1, 1));
  EXPECT_EQ(end("G92 Z5\nM70\nG92.2\nM72"), Vec3(1, 1, -4));
  EXPECT_EQ(end("G92 Z5\nM70\nG92 Z9\nM72"), Vec3(1, 1, -8));
  EXPECT_EQ(end("G92 Z5\nM70\nG92.1\nM72"), Vec3(1, 1, 1));
  EXPECT_EQ(end("M70\nG52 Z5\nM72"), Vec3(1, 1, 1));
}

// lcn-5-M70
TEST(LinuxCncFunction, SavedStates) {
  const std::string show =
      "(debug,#<_metric> #<_plane> #<_feed> #<_rpm> #<_spindle_on> #<_flood> #<_coord_system> "
      "#<_retract_old_z>)\n";
  EXPECT_EQ(
      told(lcn("G21 F100 S500\nM70\nG20 G91 G18 F5 S7 M3 M8 G55 G98\n" + show + "M72\n" + show + "M2\n")),
      (Lines{"0.000000 180.000000 5.000000 7.000000 1.000000 1.000000 550.000000 1.000000",
             "1.000000 170.000000 100.000000 500.000000 0.000000 0.000000 540.000000 0.000000"}));
  const char* const kInvalid = "Cannot restore context from invalid stack frame - missing M70/M73?";
  EXPECT_EQ(messageOf("M72"), kInvalid);
  EXPECT_EQ(messageOf("M70\nM71\nM72"), kInvalid);
  EXPECT_EQ(told(lcn("G21\no1 sub\nM73\nG20 G91\n(debug,#<_metric>)\no1 endsub\no1 call\n(debug,#<_metric> "
                     "#<_absolute>)\nM2\n")),
            (Lines{"0.000000", "1.000000 1.000000"}));
  EXPECT_EQ(messageOf("G21\no1 sub\nM70\nG20 G91\no1 endsub\no1 call\nM72"), kInvalid);
  EXPECT_EQ(messageOf("G21\nM70\no1 sub\nM72\no1 endsub\nG20\no1 call"), kInvalid);
  EXPECT_EQ(lcn("M73\nG20\nM2\n").error(), "");
}

// lcn-2-inihal
TEST(LinuxCncMachine, TellsWhichPinIsMissing) {
  const IsoRun run = lcn("F#<_hal[plasmac.cut-feed-rate]>\nM2\n");
  EXPECT_EQ(run.error(), "linuxcnc-not-defined");
  EXPECT_NE(run.message().find("[control.linuxcnc.hal] \"plasmac.cut-feed-rate\""), std::string::npos)
      << run.message();
  EXPECT_EQ(lcn("F#<_hal[plasmac.cut-feed-rate]> G1 X3\nM2\n", {},
                withTexts({{"hal.plasmac.cut-feed-rate", "900"}}))
                .motions(),
            (Lines{"F 3 0 0"}));
}

// lcn-1-ini lcn-1-units lcn-2-inihal
TEST(LinuxCncMachine, IniFile) {
  const ControlSettings settings =
      withTexts({{"ini",
                  "[TRAJ]\nLINEAR_UNITS = inch\nCOORDINATES = X Y Z A\nFOO=3.5\n"
                  "[RS274NGC]\nRS274NGC_STARTUP_CODE = G20 G91\n[AXIS_Z]\nMIN_LIMIT = -2\n"
                  "MAX_LIMIT = 2\n"},
                 {"hal.motion.in", "4"}});
  const IsoRun run =
      lcn("(debug,#<_ini[TRAJ]FOO> #<_ini[traj]foo> #<_ini[X]y> #<_hal[motion.in]>)\n"
          "(debug,#<_imperial> #<_incremental> EXISTS)\nG0 X1 A90\nG10 L2 P2 X1\n(debug,#5241)\nM2\n",
          {}, settings);
  EXPECT_EQ(told(run), (Lines{"3.500000 3.500000 ###### 4.000000", "1.000000 1.000000 EXISTS", "1.000000"}))
      << run.message();
  const IsoRun beyond = lcn("G0 Z3\nM2\n", {}, settings);
  EXPECT_TRUE(std::any_of(beyond.path.events.begin(), beyond.path.events.end(),
                          [](const auto& e) { return e.event.template as<event::Overtravel>() != nullptr; }));
}

TEST(LinuxCncMachine, RotaryAxesOfTheProgram) {
  const IsoRun run = lcn("#1=45\nG0 X1 a#1 (B5)\n(debug,#<_a> #<_b>)\nM2\n");
  EXPECT_EQ(told(run), (Lines{"45.000000 0.000000"})) << run.message();
  EXPECT_TRUE(run.tells("linuxcnc-axes"));
  EXPECT_FALSE(lcn("#1=ABS[-4]\n#<a>=ATAN[1]/[2]\no<cab> if [1]\no<cab> endif\nG0 X#<a>\nM2\n")
                   .tells("linuxcnc-axes"));
  EXPECT_TRUE(lcn("A5\n", {}, withTexts({{"axes", "XYZ"}})).message().starts_with("Bad character 'a' used"));
  EXPECT_EQ(lcn("G0 W5 U1\n(debug,#<_w> #<_u>)\nM2\n", {}, withTexts({{"axes", "XYZUW"}})).error(), "");
}

// lcn-1-remap lcn-1-python
TEST(LinuxCncMachine, Remaps) {
  const std::map<std::string, std::string> files = {
      {"chg.ngc",
       "o<chg> sub\n(debug,sel #<_selected_tool>)\nM6\n(debug,cur #<_current_tool>)\no<chg> endsub\n"},
      {"hole.ngc", "o<hole> sub\nG0 X#<x>\nG0 Z#<z>\no<hole> endsub\n"},
  };
  const ControlSettings settings =
      withTexts({{"remap.M6", "chg.ngc"},
                 {"remap.G88.6", "hole"},
                 {"ini", "[RS274NGC]\nREMAP=M400 python=foo\nREMAP=M140 modalgroup=10 py=foo\n"}});
  EXPECT_EQ(told(lcn("T4 M6\nM2\n", files, settings)), (Lines{"sel 4.000000", "cur 4.000000"}));
  EXPECT_EQ(lcn("G88.6 X3 Z4\nM2\n", files, settings).motions(), (Lines{"R 3 0 0", "R 3 0 4"}));
  EXPECT_EQ(lcn("M140 P1\nM2\n", files, settings).error(), "linuxcnc-python-remap");
  // Codes above M199 are there only so.
  EXPECT_EQ(lcn("M428 X3\nM2\n", {{"kins.ngc", "o<kins> sub\nG0 X#<x>\no<kins> endsub\n"}},
                withTexts({{"remap.M428", "kins"}}))
                .motions(),
            (Lines{"R 3 0 0"}));
  EXPECT_EQ(lcn("M428\nM2\n").error(), "linuxcnc-m-range");
  EXPECT_EQ(lcn("M6\nM2\n", {}, settings).error(), "linuxcnc-remap");
}

// lcn-2-persist
TEST(LinuxCncMachine, KeptParameters) {
  const ControlSettings settings =
      withTexts({{"parameters", "5161 1.5\n5220 2\n5241 10\n5242\t20\n5250 90\n31 7\n5210 1\n5211 -2\n"}});
  const IsoRun run =
      lcn("(debug,#5161 #5220 #5241 #5250 #31 #5210 #5211)\nG0 X0 Y0\n(debug,#<_abs_x> #<_abs_y>)\nM2\n", {},
          settings);
  EXPECT_EQ(told(run), (Lines{"1.500000 2.000000 10.000000 90.000000 7.000000 1.000000 -2.000000",
                              "10.000000 18.000000"}))
      << run.message();
  EXPECT_EQ(lcn("M2\n", {}, withTexts({{"parameters", "5161 x\n"}})).error(), "linuxcnc-machine-file");
  EXPECT_EQ(told(lcn("#5242=20 #5241=10\nG55\nG0 X1 Y2\n(debug,#<_abs_x> #<_abs_y>)\nM2\n")),
            (Lines{"11.000000 22.000000"}));
}

// lcn-2-sysparams
TEST(LinuxCncMachine, SystemParameters) {
  EXPECT_EQ(told(lcn("G0 X5 Y6 Z7\nG28.1\nG92 X1\nG10 L2 P2 X3 R15\n(debug,#5161 #5163 #5210 #5211 #5241 "
                     "#5250 #5220 #5420 #5422)\nM2\n")),
            (Lines{"5.000000 7.000000 1.000000 4.000000 3.000000 15.000000 1.000000 1.000000 7.000000"}));
}

// lcn-1-start
TEST(LinuxCncMachine, StateAtTheStart) {
  EXPECT_EQ(
      told(lcn(
          "(debug,#<_plane> #<_metric> #<_absolute> #<_units_per_minute> #<_ccomp> #<_coord_system> "
          "#<_motion_mode>)\n(debug,#<_retract_r_plane> #<_spindle_rpm_mode> #<_lathe_radius_mode> #<_feed> "
          "#<_rpm> #<_tool_offset>)\nM2\n")),
      (Lines{"170.000000 1.000000 1.000000 1.000000 400.000000 540.000000 800.000000",
             "1.000000 1.000000 1.000000 0.000000 0.000000 0.000000"}));
  EXPECT_EQ(told(lcn("(debug,#<_plane> #<_lathe_diameter_mode>)\nM2\n", {}, runAtZero({{"lathe", 1.0}}))),
            (Lines{"180.000000 0.000000"}));
}

// lcn-2-order
TEST(LinuxCncLine, OrderOfExecution) {
  // F and S first, the tool before the spindle, modes before the motion, stops last.
  EXPECT_EQ(lcn("G1 X1 G91 F100\nX1 G20\nM2\n").motions(), (Lines{"F 1 0 0", "F 26.4 0 0"}));
  EXPECT_EQ(lcn("X5 M2 G0\n").motions(), (Lines{"R 5 0 0"}));
  EXPECT_EQ(lcn("G10 L2 P2 X10\nG55 G0 X1\nM2\n").motions(), (Lines{"R 11 0 0"}));
}

}  // namespace
}  // namespace proveout::test

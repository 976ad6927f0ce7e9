// Settings of lathes: tools, cycles, threads (section 1 of the rows).
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/iso/parameters/parameter_rows.h"

namespace proveout::nc {

void addLatheRows(ParameterTable& table) {
  using namespace param_rows;
  constexpr double kLongMm = 1e5;
  table
      .add(FanucParam::kGcodeSystem,
           choice("gcode_system", kNoNumber, 0, "A B C", "system of G codes of a lathe (3401#6, #7)"))
      .add(FanucParam::kLatheT,
           atBit(choice("lathe_t", 5002, 0, "4 2", "digits of T: tool and offset, half each"), 0))
      .add(FanucParam::kGeometryBy,
           atBit(choice("geometry_by", 5002, 0, "offset tool", "which number of T names the geometry offset"),
                 1))
      .add(FanucParam::kOffsetX, number("offset_x", kNoNumber, kAxis, 0, -kLongMm, kLongMm,
                                        "geometry offset of that number along X, a diameter, mm"))
      .add(FanucParam::kOffsetZ, number("offset_z", kNoNumber, kAxis, 0, -kLongMm, kLongMm,
                                        "geometry offset of that number along Z, mm"))
      .add(FanucParam::kWearX, number("wear_x", kNoNumber, kAxis, 0, -kLongMm, kLongMm,
                                      "wear offset of that number along X, a diameter, mm"))
      .add(FanucParam::kWearZ,
           number("wear_z", kNoNumber, kAxis, 0, -kLongMm, kLongMm, "wear offset of that number along Z, mm"))
      .add(FanucParam::kNoseRadius,
           number("nose_radius", kNoNumber, kAxis, 0, -1e3, 1e3, "nose radius of that offset, mm"))
      .add(FanucParam::kTip, number("tip", kNoNumber, kAxis, 0, 0, 9, "tip of that offset, 0 to 9"))
      .add(FanucParam::kG71Depth,
           number("g71_depth", 5132, kChannel, 2.0, 1e-4, kLongMm, "depth of a level of G71, G72, mm"))
      .add(FanucParam::kG71Escape,
           number("g71_escape", 5133, kChannel, 0.5, 0, kLongMm, "escape behind a level of G71, G72, mm"))
      .add(FanucParam::kG71Levels, choice("g71_levels", kNoNumber, 0, "C A",
                                          "where levels count from: C with the allowance, A without"))
      .add(FanucParam::kG73X,
           number("g73_x", 5135, kChannel, 0, -kLongMm, kLongMm, "stock of G73 along X, a radius, mm"))
      .add(FanucParam::kG73Z,
           number("g73_z", 5136, kChannel, 0, -kLongMm, kLongMm, "stock of G73 along Z, mm"))
      .add(FanucParam::kG73Passes, number("g73_passes", 5137, kChannel, 1, 1, 5000, "passes of G73"))
      .add(FanucParam::kG74Return,
           number("g74_return", 5139, kChannel, 0.5, 0, kLongMm, "return between the pecks of G74, G75, mm"))
      .add(FanucParam::kThreadChamfer,
           number("thread_chamfer", 5130, kChannel, 1.0, 0, 100, "run-out of threads, in leads"))
      .add(FanucParam::kThreadChamferAngle,
           number("thread_chamfer_angle", 5131, kChannel, 45, 1, 89, "of the run-out to the thread, degrees"))
      .add(FanucParam::kG76Min,
           number("g76_min", 5140, kChannel, 0.05, 0, kLongMm, "least depth of a pass of G76, mm"))
      .add(FanucParam::kG76Finish,
           number("g76_finish", 5141, kChannel, 0.05, 0, kLongMm, "finish allowance of G76, mm"))
      .add(FanucParam::kG76Repeat, number("g76_repeat", 5142, kChannel, 1, 0, 99, "finish passes of G76"))
      .add(FanucParam::kG76Angle, number("g76_angle", 5143, kChannel, 60, 0, 120, "angle of G76, degrees"))
      .add(FanucParam::kPeckToR,
           atBit(choice("lathe_peck", 5101, 0, "short full",
                        "G83, G87 of lathes return a little between pecks, or to level R"),
                 2))
      .add(FanucParam::kWearMoves,
           atBit(
               choice(
                   "wear_moves", 5002, 0, "next t_block",
                   "the wear offset of T moves the tool with the axis's next motion, or with the block of T"),
               6));
  constexpr double kMostM = 99999999;
  const auto live = [&](FanucParam row, std::string_view name, std::string_view meaning) {
    table.add(row, atPowerOn(number(name, kNoNumber, kChannel, 0, 0, kMostM, meaning)));
  };
  live(FanucParam::kLiveCw, "live.cw", "M code that turns live tools clockwise; Haas 133");
  live(FanucParam::kLiveCcw, "live.ccw", "M code that turns live tools counter-clockwise; Haas 134");
  live(FanucParam::kLiveStop, "live.stop", "M code that stops live tools; Haas 135");
  live(FanucParam::kAxisOn, "live.c_on", "M code that makes the main spindle the C axis; Haas 154");
  live(FanucParam::kAxisOff, "live.c_off", "M code that makes the C axis the main spindle; Haas 155");
}

}  // namespace proveout::nc

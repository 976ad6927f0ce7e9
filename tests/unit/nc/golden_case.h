// A golden file: a program, its settings, facts known independently, and the text that the interpreter makes.
//
//   === about        free text; "proves: id id ..." names coverage ids
//   === settings     one a line: H1 = 10, D1 = 5, G54 = 1 2 3, start = 0 0 50, N1339 = 0.01, skip = 1,
//                    insert2 = NX NZ [GX GZ] (nose centre and gauge seen from the touch-off point),
//                    axis = C 6 rotary rapid 3600 limit -360 360, machine = FILE (a machine file, seen from
//                    the project's folder; axes stand behind it), ...; of the person at the machine:
//                    answer107 = 2, plc_bit3 = 1, plc_number1 = 2.5, date, time, test_mode; main_name =
//                    O0012.nc;
//                    material for measuring moves: probe = plane NX NY NZ D (where N.p >= D),
//                    probe = box X0 Y0 Z0 X1 Y1 Z1
//   === main         the main program (a file may start with it and leave the marker out)
//   === sub NAME     a subprogram
//   === channel N [KEY = VALUE;...]  the program of channel N, 2 to 8, and settings of its own; the main
//                    program is that of channel 1, subprograms are there for all
//   === truth        motion ends from the manual, in order: x y z [center x y z] [sweep deg] [F feed]
//                    [t seconds] [S spindle] [T tool] [ch channel] [rotary ends] [at part-of-the-way x y
//                    z]...; * is anything. Of a wire: end of its lower track, then [center x y] [sweep deg]
//                    [at part-of-the-way x y z], `upper` and the same of its upper track; a track without
//                    sweep is a line. One line may be the way of all cuts, mm: length lower [upper].
//                    Where motions go along chords: `line N`, the same of the last motion of that line of the
//                    main program, with [axis x y z] (the tool's direction); every line that moves is told,
//                    and the expected text has no motions
//   === says         what the text must hold, in this order: alarms, events, files written
//   === characterisation  why there is no independent value: the file only guards what the program does
//                    today. Every file has a truth, a says or this
//   === expect       what the interpreter says; rewritten with PROVEOUT_UPDATE_GOLDEN=1
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/registry/interpreter.h"

namespace proveout::test {

struct GoldenCase {
  std::string path;
  std::string head;  ///< everything before the expected text
  std::string about, settings_text, main_text, truth, says, characterisation, expect;
  std::vector<std::pair<std::string, std::string>> subprograms;
  struct Channel {
    int number = 0;
    std::string settings_text, text;
  };
  std::vector<Channel> channels;  ///< besides the first
};

/// What the expectation is held against: nothing but itself, the words that it must hold, or the motions too.
enum class GoldenProof { kNone, kCharacterisation, kSays, kTruth };
/// A file that is named characterisation counts as such whatever else it has.
GoldenProof proofOf(const GoldenCase& golden);

GoldenCase readGolden(const std::string& path);
void writeGolden(const GoldenCase& golden, const std::string& expect);
/// Throws std::runtime_error for a line that it does not know.
ControlSettings settingsOf(const std::string& text);

struct GoldenMotion {
  Motion motion;
  ArcGeometry arc;
  bool is_arc = false;
  AxisSweep axis;
  std::optional<WireSweep> wire;  ///< of a control that moves a wire
};
/// Runs the case; appends the motions to `motions`, returns the text. `as_channel`: a program alone is run as
/// the one channel of a control with channels.
std::string runGolden(const GoldenCase& golden, std::vector<GoldenMotion>& motions, bool as_channel = false);

/// The path of the case with its origins, and the texts that they are in.
struct GoldenPath {
  Toolpath path;
  /// Text of a line; empty where no program of the case has that name.
  std::string line(std::uint32_t file, std::uint32_t number) const;
  std::map<std::string, std::vector<std::string>> texts;  ///< lines by name of the program
};
GoldenPath pathOfGolden(const GoldenCase& golden);

/// Empty if the motions agree with the truth section, else what differs.
std::string compareWithTruth(const std::string& truth, const std::vector<GoldenMotion>& motions);

/// Empty if each line of `says` stands in a line of the text, in order; else the first that is missing.
std::string missingIn(const std::string& text, const std::string& says);

}  // namespace proveout::test

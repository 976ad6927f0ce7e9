// What a virtual control needs to know besides the program: plain data, filled from the job.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/machine/machine_model.h"
#include "core/nc/control/machine_event.h"

namespace proveout {

enum class LengthUnit { kMillimetre, kInch };

/// Text encoding of program files. kAuto: UTF-8 where the bytes are valid UTF-8, else the Cyrillic code
/// page that fits the text better.
enum class TextEncoding { kAuto, kUtf8, kKoi8R, kCp1251, kGb18030 };

/// What a rotary axis turns.
enum class RotaryCarries {
  kDefault,  ///< A, B, C turn the part about X, Y, Z; axes with other letters nothing
  kPart,     ///< a table
  kNothing   ///< its position is only told, not in the path
};

/// An axis besides X, Y, Z, or the number of one of these.
struct AxisSettings {
  std::string name;  ///< "C", "U", "Z1": upper case
  int number = 4;    ///< axis number of the machine, 1 to 32
  AxisKind kind = AxisKind::kRotary;
  std::string parallel;  ///< "X", "Y" or "Z": the linear axis moves the tool in that direction too; or empty
  double rapid = 15000.0;          ///< mm/min or deg/min; > 0
  double acceleration = 0.0;       ///< mm/s^2 or deg/s^2; 0: reaches its speed at once
  double start = 0.0;              ///< machine position at power-on, mm or deg
  double reference = 0.0;          ///< machine position of the reference points, mm or deg
  std::optional<AxisLimit> limit;  ///< machine coordinates, mm or deg

  // Rotary axes. A table that stands on another one comes behind it in the list.
  RotaryCarries carries = RotaryCarries::kDefault;
  std::optional<Vec3> direction;  ///< of a table, with all tables at 0; default by the letter: A X, B Y, C Z
  std::optional<Vec3> center;     ///< a point of that axis, machine frame, mm; default: workpiece origin
};

/// Speeds that a gear of a spindle has, 1/min.
struct SpindleRange {
  double min = 0.0;
  double max = 0.0;
};

/// A spindle of the machine. Codes are M numbers; 0: there is none.
struct SpindleSettings {
  int number = 1;                     ///< 1 to 16; S with P names it
  std::string name;                   ///< "S2", "SSB": programs set its speed by it; empty: by plain S only
  std::vector<SpindleRange> ranges;   ///< of M11, M12, ... up to 8; none: any speed
  double acceleration = 0.0;          ///< 1/min per second; 0: it reaches its speed at once
  double top_rpm = 0.0;               ///< no faster than this when spindles run together; 0: no limit
  double positioning_rpm = 60.0;      ///< speed at which it turns to an angle, > 0
  std::string position_name;          ///< "CS2": programs turn it to an angle by it
  std::string axis;                   ///< name of the axis that it can become
  int main_code = 0;                  ///< makes it the main spindle
  int sync_code = 0, shift_code = 0;  ///< the spindle named last follows the main one, in phase or shifted
  int axis_code = 0;                  ///< makes it its axis
  int speed_code = 0;                 ///< ends that
  /// Turn it, which makes it the main spindle, with S its own, until the last of them stops it.
  int cw_code = 0, ccw_code = 0, stop_code = 0;
  bool speed_by_p = false;  ///< P beside these two codes is its speed
};

/// A row of the offset tables, mm. Effective value: geometry + wear.
struct OffsetValue {
  double geometry = 0.0;
  double wear = 0.0;
};

/// How a lathe insert stands in its turret. X as a radius, mm.
struct InsertMount {
  Vec2 nose_center = Vec2::Zero();  ///< (x, z) of the nose centre seen from the touch-off point P
  /// (x, z) of what the machine counts from, seen from P: what the tool's offsets have to make up for. None:
  /// the operator has measured right, whichever point the program moves.
  std::optional<Vec2> gauge;
};

/// Where the machine goes for a tool change, machine frame, mm: first up to `z`, never down, then level to
/// `x` and `y`. Axes without a value stay where they are.
struct ToolChangePlace {
  std::optional<double> x, y, z;
  bool by_default = false;  ///< nobody named it: it ends at the limits of travel instead of passing them

  bool any() const { return x || y || z; }
};

/// Stops the interpretation after a block of the main program: by line (from 1) or by N number.
struct UntilBlock {
  std::optional<int> line;
  std::optional<std::int64_t> block;

  /// By a block with that N number (below 0: none), on the line of that index.
  bool reachedBy(std::int64_t number, std::size_t line_index) const {
    if (block && number == *block) return true;
    return line && static_cast<int>(line_index) + 1 >= *line;
  }
};

/// Where the workpiece really lies in the machine, whatever the operator has entered.
struct WorkpiecePlacement {
  std::optional<Vec3>
      origin;                 ///< of the workpiece frame, machine frame, mm; none: where the work offset says
  double rotation_deg = 0.0;  ///< of that frame about the machine's Z, counterclockwise seen from +Z
};

struct ControlSettings {
  int channel = 0;  ///< number of the control's channel, 1 to 8; 0: not told, the control has one
  int tool = 0;     ///< number of the tool in the spindle at power-on; 0: not told
  LengthUnit units = LengthUnit::kMillimetre;   ///< power-on unit, where the program does not say (G20/G21)
  TextEncoding encoding = TextEncoding::kAuto;  ///< of the program files
  Vec3 rapid_mm_min = Vec3::Constant(15000.0);  ///< rapid rate of X, Y, Z; > 0
  bool rapid_by_default = true;                 ///< nobody named these rates
  Vec3 acceleration_mm_s2 = Vec3::Zero();       ///< of X, Y, Z; 0: the axis reaches its speed at once
  double bell_time_s = 0.0;  ///< in which the acceleration along the path comes up; 0: at once
  std::array<std::optional<AxisLimit>, 3> limits;  ///< X, Y, Z, machine frame, mm
  /// Ends of the axes, "Z+", at which the machine's PLC has chosen range B of the control's stroke limits.
  std::vector<std::string> stroke_range_b;
  std::vector<AxisSettings> axes;  ///< besides X, Y, Z
  /// How the machine is built; its axes are X, Y, Z and those of `axes`, in that order. None: see
  /// machineOf().
  std::optional<MachineModel> machine;
  std::vector<SpindleSettings> spindles;  ///< none: one without limits, called by S
  std::vector<MachineEvent> events;       ///< what M codes do to axes; see eventFaults()
  /// Axes with two drives, master first: one axis to programs. The slave is always where its master is.
  std::vector<AxisPair> gantry, tandem;
  Vec3 start = Vec3(0, 0, 100);   ///< where the tool is at power-on, workpiece frame, mm
  bool start_by_default = false;  ///< nobody named it: it keeps below the ends of travel

  /// Work offsets G54..G59 in the machine frame, mm, and their basic rotation angles about X, Y, Z (deg).
  std::array<Vec3, 6> work_offsets{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                   Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::array<Vec3, 6> work_rotations_deg{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                         Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::map<int, Vec3> extended_offsets;  ///< G54.1 P1..P99, machine frame, mm
  Vec3 common_offset = Vec3::Zero();     ///< added to every work offset, mm
  std::array<bool, 6> work_given{};      ///< which of G54..G59 the job gives a value
  /// Not known to the controls: they tell their paths in the machine frame moved to G54 and the common
  /// offset.
  WorkpiecePlacement placement;

  /// Reference points 1..4 in the machine frame, mm (G28, G30). Where one is not given, the start
  /// position stands for it and a warning says so.
  std::array<std::optional<Vec3>, 4> reference_points;

  std::map<int, OffsetValue> length_offsets;  ///< H rows, mm
  std::map<int, OffsetValue> radius_offsets;  ///< D rows, mm (radius)
  std::map<int, double> gauge_lengths;        ///< by tool number, mm; 0 for tools not listed
  std::map<int, double> tool_radii;           ///< of milling cutters by tool number, mm
  std::map<int, InsertMount> inserts;         ///< by tool number
  Vec3 unnamed_gauge = Vec3::Zero();          ///< of what is in the spindle at power-on where `tool` is 0, mm

  std::uint64_t block_limit = 100'000'000;  ///< executed blocks; more is an alarm (endless loop)
  std::array<bool, 9> skip_switches{};      ///< [0] is the switch of `/` and `/1`, [8] of `/9`
  bool optional_stop = false;               ///< M1 stops
  /// N numbers of the main program at whose end the signal comes that starts the interrupt macro (M96).
  std::vector<std::int64_t> interrupt_blocks;
  bool lenient = false;                 ///< unsupported codes that are safe to skip become warnings
  double tool_change_s = 5.0;           ///< duration of a tool change, s
  ToolChangePlace tool_change;          ///< no axis: the machine stays where the program has left it
  double default_spindle_rpm = 1000.0;  ///< timing of G95 motions and dwells while the spindle stands still
  int max_errors = 1;                   ///< interpretation goes on behind bad blocks until so many errors
  std::optional<UntilBlock> until;

  /// Parameters of the control by name ("N1339" = 0.01, "N1337.SEC" = 1). Unknown names are errors.
  std::map<std::string, double> parameters;
  /// Settings of the control that are no numbers, by name: texts, and files as their text ("tool_table").
  /// Names that the control does not know are errors of the job.
  std::map<std::string, std::string> texts;
};

/// Machine point of the zero that the job's G54 and common offset name, mm.
inline Vec3 offsetZero(const ControlSettings& settings) {
  return settings.work_offsets[0] + settings.common_offset;
}
/// Machine point of the origin of the workpiece frame, mm.
inline Vec3 workpieceZero(const ControlSettings& settings) {
  return settings.placement.origin.value_or(offsetZero(settings));
}

/// Numbers of work systems: 1 to 6 are G54 to G59, from this one on G54.1 P1 to P99.
inline constexpr int kFirstExtendedSystem = 101;
/// "G55", "G54.1 P3".
inline std::string workSystemName(int system) {
  if (system < kFirstExtendedSystem) return "G" + std::to_string(53 + system);
  return "G54.1 P" + std::to_string(system - kFirstExtendedSystem + 1);
}

/// Whether the job leaves a work system without a value and it matters: where it gives none at all, G54 is
/// the workpiece's own zero.
inline bool lacksWorkOffset(const ControlSettings& settings, int system) {
  if (system >= kFirstExtendedSystem)
    return !settings.extended_offsets.contains(system - kFirstExtendedSystem + 1);
  if (system < 1 || settings.work_given[static_cast<std::size_t>(system - 1)]) return false;
  const auto given = [](bool one) { return one; };
  return system > 1 || !settings.extended_offsets.empty() ||
         std::any_of(settings.work_given.begin(), settings.work_given.end(), given);
}

}  // namespace proveout

// What the rules of LinuxCNC keep of a channel beside the state of the family.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/iso/context/context.h"
#include "core/nc/linuxcnc/model/flavour.h"
#include "core/nc/linuxcnc/model/groups.h"
#include "core/nc/linuxcnc/stages/comp_stage.h"

namespace proveout::nc {

/// One step of a block. Points are program coordinates, mm and degrees.
struct LinuxCncStep {
  enum class Kind : std::uint8_t {
    kRapid,
    kFeed,
    kArc,
    kThread,        ///< line, synchronous with the spindle
    kMachineRapid,  ///< `to` in machine coordinates
    kDwell,
    kSpindle,  ///< the spindle turns (value +1, -1) or stops (0)
    kOrient,
    kStop,
    kMode  ///< nothing moves
  };
  Kind kind = Kind::kRapid;
  AxisPoint to;
  Vec2 center = Vec2::Zero();  ///< kArc: (u, v)
  double sweep = 0.0;          ///< kArc: rad, > 0 from u to v
  double value = 0.0;          ///< kDwell: s; kThread: lead, mm a turn; kSpindle: direction
  bool probes = false;         ///< kFeed: measures
  bool bare = false;           ///< kRapid: without the compensation that is on, which begins behind it
};

/// Words that hold while the same cycle code repeats. Lengths as programmed, in mm.
struct LinuxCncCycle {
  double z = 0.0, r = 0.0;
  double q = 0.0, p = 0.0;        ///< 0: not given
  double unit = 1.0;              ///< mm of the units that these were given in
  std::optional<Vec3> back_bore;  ///< I, J, K of G87
  double old_level = 0.0;         ///< of the drill axis before the first cycle of the series
};

/// Modal data that the family has not.
struct LinuxCncModal {
  double feed = 0.0;            ///< F in mm (a minute, or a turn), by the units of its line
  double feed_number = 0.0;     ///< F as written: degrees of motions of rotary axes alone, 1/min in G93
  bool dynamic_radius = false;  ///< compensation by G41.1, G42.1
  bool arc_after_comp = true;   ///< false: compensation ended and nothing moved since
  LinuxCncCycle cycle;
  std::optional<Vec2> cubic;  ///< P Q of the G5 before, mm
  std::int8_t nurbs = 0;      ///< a block of 1 G5.2, 2 G6.2 is open
};

/// Points of an open NURBS block.
struct LinuxCncNurbs {
  std::vector<Vec3> points;  ///< (u, v, weight), mm
  std::vector<double> knots;
  int order = 3;
  AxisPoint last;  ///< the last point, program coordinates
  // What the block in hand adds.
  std::vector<Vec3> added;
  std::optional<double> added_knot;
  int added_order = 0;  ///< 0: none
};

/// Frames as the block in hand leaves them.
struct LinuxCncFrames {
  AxisPoint shift;     ///< of G92 and G52, kept
  AxisPoint in_force;  ///< the same, or 0 while it is off
  bool shift_on = false;
  WorkSystemId id = -1;  ///< -1: no work system changes
  WorkSystem system;
};

/// A line of the sub that G70, G71 and G72 take their contour from.
struct LinuxCncContourLine {
  std::vector<Word> words;
  std::size_t line = 0;  ///< index in its text
};

/// What G10 L0, L1, L10, L11 sets.
struct LinuxCncToolData {
  int row = 0;                                  ///< 0: the table is read anew
  std::array<std::optional<double>, 3> offset;  ///< mm
  std::optional<double> radius, front, back;    ///< mm, degrees
  std::optional<int> tip;
};

class LinuxCncChannel final : public MakerData {
 public:
  explicit LinuxCncChannel(IsoContext& c);
  /// The next block is planned.
  void begin() {
    steps.clear();
    pending.reset();
    stores_home = 0;
    next = modal;
  }

  std::optional<LinuxCncFlavour> flavour;  ///< from when the run begins
  LinuxCncModal modal;                     ///< in force
  LinuxCncModal next;                      ///< as the block in hand leaves it
  std::vector<LinuxCncStep> steps;
  LinuxCncNurbs nurbs;
  std::optional<LinuxCncFrames> pending;  ///< planned by the block in hand
  int stores_home = 0;                    ///< 281, 301: the block in hand is G28.1, G30.1
  LinuxCncToolData tool_data;
  /// The lines of the sub of G70, G71, G72 in the block in hand; nothing: there is no such sub.
  std::optional<std::vector<LinuxCncContourLine>> contour;
  std::optional<AxisPoint> contour_at;          ///< while that sub runs: where its lines have come to
  AxisPoint home28, home30;                     ///< of G28 and G30, machine coordinates
  bool arc_mode_said = false;                   ///< the program has given G90.1 or G91.1
  bool homes_known = false;                     ///< somebody said where they are
  AxisPoint shift;                              ///< of G92 and G52 as #5211 keeps it, program coordinates
  bool shift_on = false;                        ///< #5210
  AxisPoint probe_at;                           ///< of the last probing move, program coordinates: #5061 ..
  bool probe_met = false;                       ///< #5070
  std::optional<Vec3> probe_way;                ///< of the last probing move if it met, workpiece frame, unit
  AxisPoint probe_end;                          ///< where it ended, machine
  std::map<int, std::array<double, 2>> angles;  ///< front and back angle by tool, degrees
  LinuxCncCompStage comp;
};

/// That of a channel of this control.
inline LinuxCncChannel& linuxCncChannel(IsoContext& c) { return static_cast<LinuxCncChannel&>(*c.maker); }
inline const LinuxCncChannel& linuxCncChannel(const IsoContext& c) {
  return static_cast<const LinuxCncChannel&>(*c.maker);
}
std::unique_ptr<MakerData> makeLinuxCncChannel(IsoContext& c);

}  // namespace proveout::nc

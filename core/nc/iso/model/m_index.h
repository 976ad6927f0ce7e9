// M codes by number: the control's own, and what parameters and settings make of others.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/nc/control/control_settings.h"
#include "core/nc/iso/model/codes.h"
#include "core/nc/iso/parameters/parameters.h"
#include "core/nc/kinematics/axes.h"

namespace proveout::nc {

/// What a block asks of the interrupt macro.
enum class InterruptSwitch : std::uint8_t { kNone, kOn, kOff };

/// What M codes of neighbouring numbers mean on this machine. Spindles are told by index.
struct MFunction {
  int first = 0;                 ///< they begin here and end in front of the next row
  const MCode* own = nullptr;    ///< the control's row; null: the control has none
  std::int8_t group = 0;         ///< of N1341 to N1372, 1 to 16; 0: none
  bool waits = false;            ///< N2201 to N2202: channels meet
  bool ends_look_ahead = false;  ///< one of the parameters BUF: blocks are read only when it is done
  bool of_place = false;         ///< M62 or another one (N2924): T names a place of the magazine
  InterruptSwitch interrupt = InterruptSwitch::kNone;
  const MachineEvent* event = nullptr;                      ///< of the settings: what it does to axes
  bool of_spindles = false;                                 ///< further spindle code
  std::bitset<kSpindleNames> closes_loop;                   ///< of the spindle that is programmed
  std::bitset<kSpindleNames> indexes;                       ///< turns it by an angle
  std::int8_t main = -1, sync = -1, shift = -1, axis = -1;  ///< spindle whose settings name it so
  std::int8_t speed = -1, cw = -1, ccw = -1, stop = -1;     ///< the same

  /// Does it belong to the spindles while S names that one?
  bool ofSpindle(int programmed) const {
    const auto at = static_cast<std::size_t>(programmed);
    return of_spindles || closes_loop[at] || indexes[at] || main >= 0 || sync >= 0 || shift >= 0 ||
           axis >= 0 || speed >= 0 || stop >= 0 || started() >= 0;
  }
  /// The spindle that it turns; -1: none.
  int started() const { return cw >= 0 ? cw : ccw; }
  /// Codes of one such group exclude each other in a block; 0: it is of none.
  int exclusive(int programmed) const {
    if (own != nullptr) return own->exclusive;
    const bool turns = stop >= 0 || started() >= 0;
    return turns || of_spindles || closes_loop[static_cast<std::size_t>(programmed)] ? kSpindleCodes : 0;
  }
  MPhase phase() const {
    return own != nullptr ? own->phase : started() >= 0 ? MPhase::kBefore : MPhase::kAfter;
  }
};

/// Rows for all M codes, worked out anew when a parameter has changed.
class MIndex {
 public:
  /// Both must outlive the index.
  MIndex(const CodeIndex& codes, const ControlSettings& settings) : codes_(codes), settings_(settings) {}

  /// Call before each look-up; costs a comparison.
  void update(const IsoParameters& parameters) {
    if (revision_ != parameters.revision()) rebuild(parameters);
  }
  /// The row of a code; it stays until a parameter changes. Negative numbers have one that means nothing.
  const MFunction& find(int m) const;

 private:
  void rebuild(const IsoParameters& parameters);

  const CodeIndex& codes_;
  const ControlSettings& settings_;
  std::uint32_t revision_ = 0;
  std::vector<MFunction> rows_;  ///< by first number, from 0
};

}  // namespace proveout::nc

// Work offsets, basic rotations and the table of dynamic offsets (manual 23.1.19).
#pragma once

#include <array>
#include <span>

#include "core/machine/axis_point.h"
#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

/// Numbers of work offsets: axis a (from 0) of the s-th system is #(first + s * system_step + a * axis_step).
struct FrameNumbers {
  int first = 0;
  int systems = 0, system_step = 0;
  int axes = 0, axis_step = 1;
  int first_system = 0;  ///< WorkSystemId
};
struct FrameNumbering {
  std::span<const FrameNumbers> offsets;  ///< must outlive the bank
  bool names = true;                      ///< #_WZCMN and its like; with rotations and dynamic offsets
};
/// That of nct.
FrameNumbering nctFrames();

/// Read and written in the unit in force. A written cell of the system in force moves the coordinates of what
/// follows.
class FrameBank : public VariableBank {
 public:
  explicit FrameBank(IsoContext& context, const FrameNumbering& numbering = nctFrames())
      : c_(context), numbering_(numbering) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;

 private:
  static constexpr int kDynamicSystems = 8;
  /// A cell, found by its number.
  struct Cell {
    enum class Kind { kNone, kOffset, kRotation, kDynamic, kDynamicInForce, kDynamicNow } kind = Kind::kNone;
    int system = 0;  ///< WorkSystemId; of dynamic offsets 0 to 7
    int axis = 0;    ///< index; of rotations the axis turned about
  };
  Cell offsetCell(int number) const;
  Cell dynamicCell(int number) const;
  Cell find(int number) const;
  bool axisOf(int number, Cell& cell) const;

  IsoContext& c_;
  FrameNumbering numbering_;
};

}  // namespace proveout::nc

// What Fanuc-like controls keep from block to block beside the state of the family.
#pragma once

#include <array>
#include <bitset>
#include <memory>
#include <optional>
#include <vector>

#include "core/machine/axis_point.h"
#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// A control point of G06.2, or the middle of a 3-D arc: as programmed, mm.
struct CurvePoint {
  Vec3 at = Vec3::Zero();
  double weight = 1.0;
};

/// Blocks that make one curve together: G06.2, G02.4. Program coordinates.
struct CurveInput {
  std::vector<CurvePoint> points;
  std::vector<double> knots;
  int order = 0;     ///< of G06.2; 0: none is open
  bool arc = false;  ///< a 3-D arc waits for its end
  bool open() const { return order > 0 || arc; }
};

struct FanucData : MakerData {
  bool via_known = false;
  AxisPoint via;      ///< intermediate point of the last G28 or G30, machine coordinates
  AxisSet no_length;  ///< axes whose length offset G28, G30 or G53 has ended (section 5)
  CurveInput curve;
  std::optional<std::array<int, 3>> plane_before;  ///< axes of the plane when G12.1 or G07.1 began: u, v, w
  std::bitset<kGroupCount> programmed;             ///< groups that the program has told a code of
  std::bitset<kGroupCount> noted;                  ///< groups whose code of power-on a note has told of
  bool decimal_noted = false;                      ///< a note has told of numbers without a point
  bool all_told = false;                           ///< of those that power-on codes matter for
};

inline FanucData& fanucData(IsoContext& c) { return static_cast<FanucData&>(*c.maker); }
inline const FanucData& fanucData(const IsoContext& c) { return static_cast<const FanucData&>(*c.maker); }
std::unique_ptr<MakerData> makeFanucData(IsoContext& c);

/// Is it a control of lathes?
inline bool isLathe(const IsoContext& c) { return c.dialect.name == "fanuc-lathe"; }

}  // namespace proveout::nc

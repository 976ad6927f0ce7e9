// What the rules of a Fanuc-like lathe keep of a channel beside the state of the ISO family.
#pragma once

#include <optional>
#include <vector>

#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Words of a single cycle (G90, G92, G94 of system A) that stay until another code of the group.
struct SingleCycleWords {
  std::optional<double> x, z;  ///< end, program coordinates, mm; X a radius
  double taper = 0.0;          ///< R, mm
};

/// Where a G70 has begun: the tool comes back there.
struct FinishStart {
  AxisPoint at;          ///< program coordinates
  bool comp_on = false;  ///< with nose compensation
};

struct LatheData final : FanucData {
  SingleCycleWords single;
  double thread_angle = 0.0;           ///< of the spindle where the last block of a thread ended, degrees
  bool run_out = true;                 ///< M23, M24: threads of the cycles end in a run-out
  std::vector<FinishStart> finishing;  ///< one a G70 that is open
  AxisPoint geometry;                  ///< of the offset in force, X a radius, mm
  Vec3 wear_way = Vec3::Zero();        ///< that the block in hand goes for the wear offset, program, mm
};

inline LatheData& latheData(IsoContext& c) { return static_cast<LatheData&>(*c.maker); }

}  // namespace proveout::nc

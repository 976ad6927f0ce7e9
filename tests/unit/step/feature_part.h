// A part with features of every kind, made with OpenCASCADE, whose dimensions can be changed one by one.
#pragma once

#include <TopoDS_Shape.hxx>

namespace proveout::test {

/// Dimensions, mm; angles in degrees. A diameter of 0 leaves the feature out.
struct FeaturePartSizes {
  double through_d = 8, through_x = 15, through_y = 15, through_floor = -1;  ///< down to that height
  double blind_d = 10, blind_depth = 12, blind_x = 40, blind_y = 15;
  double step_d = 12, step_depth = 6, bore_d = 6.8, step_x = 65, step_y = 15, bore_x = 65;
  double sink_d = 14, sink_angle = 90, sink_hole_d = 7, sink_x = 90, sink_y = 15;
  double drill_d = 6, drill_depth = 10, drill_tip = 118, drill_x = 110, drill_y = 15;
  double pocket_x = 30, pocket_y = 55, pocket_l = 36, pocket_w = 24, pocket_depth = 5, pocket_r = 4;
  double slot_x = 80, slot_y = 55, slot_l = 30, slot_w = 10, slot_depth = 4;
  double window_x = 110, window_y = 55, window_l = 20, window_w = 8;  ///< a slot through the part, along Y
  double boss_d = 20, boss_h = 6, boss_x = 100, boss_y = 80;
  double seat_r = 6, seat_x = 70, seat_y = 85, seat_z = 20;
  double chamfer_angle = 30, chamfer_at = 8;  ///< along the edge at X0, from the top so deep
  double fillet_r = 5;                        ///< along the upper edge at Y100
  double top = 20, side_x = 120;
};
/// A plate of 120 x 100 x 20 with them.
TopoDS_Shape featurePart(const FeaturePartSizes& sizes = {});

/// Turned about Z: a shaft with a shoulder, a cone, a groove and a bore.
struct ShaftSizes {
  double d1 = 30, l1 = 25, d2 = 20, l2 = 30;  ///< the wide part up to l1, then the narrow one for l2
  double cone_angle = 20, cone_l = 10;        ///< whole angle; at the end of the narrow part
  double bore_d = 10, bore_depth = 18;        ///< from the end
  double groove_r = 2, groove_z = 12;         ///< round groove in the wide part
};
TopoDS_Shape shaft(const ShaftSizes& sizes = {});

}  // namespace proveout::test

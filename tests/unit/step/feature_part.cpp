#include "tests/unit/step/feature_part.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <stdexcept>
#include <string>
#include <vector>

namespace proveout::test {
namespace {

gp_Ax2 upAt(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }
TopoDS_Shape without(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }
double rad(double degrees) { return degrees * M_PI / 180.0; }

TopoDS_Shape holed(const TopoDS_Shape& s, double x, double y, double d, double from, double to) {
  if (d == 0) return s;
  return without(s, BRepPrimAPI_MakeCylinder(upAt(x, y, from), d / 2, to - from).Shape());
}

/// A prism over a rectangle with round corners, or a slot where the radius is half of the width.
TopoDS_Shape roundedPrism(double x, double y, double l, double w, double r, double from, double height) {
  const double a = l / 2 - r, b = w / 2 - r;
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    if (std::hypot(x1 - x0, y1 - y0) > 1e-9)
      wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x + x0, y + y0, from), gp_Pnt(x + x1, y + y1, from)).Edge());
  };
  const auto corner = [&](double cx, double cy, double start, double sweep) {
    const auto at = [&](double angle) {
      return gp_Pnt(x + cx + r * std::cos(angle), y + cy + r * std::sin(angle), from);
    };
    wire.Add(BRepBuilderAPI_MakeEdge(
                 GC_MakeArcOfCircle(at(start), at(start + 0.5 * sweep), at(start + sweep)).Value())
                 .Edge());
  };
  if (b < 1e-9) {
    line(-a, -r, a, -r);
    corner(a, 0, -M_PI / 2, M_PI);
    line(a, r, -a, r);
    corner(-a, 0, M_PI / 2, M_PI);
  } else if (a < 1e-9) {
    line(r, -b, r, b);
    corner(0, b, 0, M_PI);
    line(-r, b, -r, -b);
    corner(0, -b, M_PI, M_PI);
  } else {
    line(-a, -b - r, a, -b - r);
    corner(a, -b, -M_PI / 2, M_PI / 2);
    line(a + r, -b, a + r, b);
    corner(a, b, 0, M_PI / 2);
    line(a, b + r, -a, b + r);
    corner(-a, b, M_PI / 2, M_PI / 2);
    line(-a - r, b, -a - r, -b);
    corner(-a, -b, M_PI, M_PI / 2);
  }
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, height)).Shape();
}

TopoDS_Shape withHoles(TopoDS_Shape s, const FeaturePartSizes& z) {
  const double top = z.top;
  s = holed(s, z.through_x, z.through_y, z.through_d, z.through_floor, 40);
  s = holed(s, z.blind_x, z.blind_y, z.blind_d, top - z.blind_depth, 40);
  s = holed(s, z.step_x, z.step_y, z.step_d, top - z.step_depth, 40);
  s = holed(s, z.bore_x, z.step_y, z.bore_d, -1, 40);
  s = holed(s, z.sink_x, z.sink_y, z.sink_hole_d, -1, 40);
  if (z.sink_d > 0) {
    const double slope = std::tan(rad(z.sink_angle / 2)), below = 5.0;
    s = without(s, BRepPrimAPI_MakeCone(upAt(z.sink_x, z.sink_y, top - below),
                                        std::max(0.0, z.sink_d / 2 - below * slope), z.sink_d / 2 + 2 * slope,
                                        below + 2)
                       .Shape());
  }
  s = holed(s, z.drill_x, z.drill_y, z.drill_d, top - z.drill_depth, 40);
  if (z.drill_d > 0) {
    const double tip = z.drill_d / 2 / std::tan(rad(z.drill_tip / 2));
    s = without(
        s, BRepPrimAPI_MakeCone(upAt(z.drill_x, z.drill_y, top - z.drill_depth - tip), 0, z.drill_d / 2, tip)
               .Shape());
  }
  return s;
}

TopoDS_Shape makeFeaturePart(const FeaturePartSizes& z);

}  // namespace

TopoDS_Shape featurePart(const FeaturePartSizes& sizes) try {
  return makeFeaturePart(sizes);
} catch (const Standard_Failure& failure) {
  throw std::runtime_error(std::string(failure.DynamicType()->Name()) + ": " + failure.GetMessageString());
}

namespace {
TopoDS_Shape makeFeaturePart(const FeaturePartSizes& z) {
  TopoDS_Shape s = BRepPrimAPI_MakeBox(z.side_x, 100, z.top).Shape();
  if (z.fillet_r > 0) {
    BRepFilletAPI_MakeFillet fillet(s);
    for (TopExp_Explorer edge(s, TopAbs_EDGE); edge.More(); edge.Next()) {
      TopExp_Explorer ends(edge.Current(), TopAbs_VERTEX);
      const gp_Pnt a = BRep_Tool::Pnt(TopoDS::Vertex(ends.Current()));
      ends.Next();
      const gp_Pnt b = BRep_Tool::Pnt(TopoDS::Vertex(ends.Current()));
      const auto on = [&](const gp_Pnt& p) { return p.Y() > 99 && p.Z() > z.top - 1; };
      if (!on(a) || !on(b)) continue;
      fillet.Add(z.fillet_r, TopoDS::Edge(edge.Current()));
      break;
    }
    s = fillet.Shape();
  }
  // A wedge along the edge at X0, whose plane leans by the angle to the top.
  const double deep = z.chamfer_at, wide = deep / std::tan(rad(z.chamfer_angle));
  BRepBuilderAPI_MakePolygon wedge;
  for (const auto& [x, h] :
       std::vector<std::pair<double, double>>{{-1, z.top + 1},
                                              {-1, z.top - deep - std::tan(rad(z.chamfer_angle))},
                                              {wide + 1 / std::tan(rad(z.chamfer_angle)), z.top + 1}})
    wedge.Add(gp_Pnt(x, 30, h));
  wedge.Close();
  // Only from Y30 to Y40 to leave the pocket alone.
  s = without(s,
              BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wedge.Wire()).Face(), gp_Vec(0, 8, 0)).Shape());
  s = withHoles(s, z);
  s = without(s, roundedPrism(z.pocket_x, z.pocket_y, z.pocket_l, z.pocket_w, z.pocket_r,
                              z.top - z.pocket_depth, 40));
  s = without(s,
              roundedPrism(z.slot_x, z.slot_y, z.slot_l, z.slot_w, z.slot_w / 2, z.top - z.slot_depth, 40));
  s = without(s, roundedPrism(z.window_x, z.window_y, z.window_w, z.window_l, z.window_w / 2, -1, 60));
  if (z.seat_r > 0)
    s = without(s, BRepPrimAPI_MakeSphere(gp_Pnt(z.seat_x, z.seat_y, z.seat_z), z.seat_r).Shape());
  if (z.boss_d > 0)
    s = BRepAlgoAPI_Fuse(
            s,
            BRepPrimAPI_MakeCylinder(upAt(z.boss_x, z.boss_y, z.top - 1), z.boss_d / 2, z.boss_h + 1).Shape())
            .Shape();
  return s;
}
}  // namespace

TopoDS_Shape shaft(const ShaftSizes& z) {
  const double end = z.l1 + z.l2, narrow = z.d2 / 2 - z.cone_l * std::tan(rad(z.cone_angle / 2));
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, h] : std::vector<std::pair<double, double>>{{0, 0},
                                                                   {z.d1 / 2, 0},
                                                                   {z.d1 / 2, z.l1},
                                                                   {z.d2 / 2, z.l1},
                                                                   {z.d2 / 2, end - z.cone_l},
                                                                   {narrow, end},
                                                                   {0, end}})
    outline.Add(gp_Pnt(x, 0, h));
  outline.Close();
  TopoDS_Shape s = BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline.Wire()).Face(),
                                         gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)))
                       .Shape();
  if (z.groove_r > 0)
    s = without(s, BRepPrimAPI_MakeTorus(upAt(0, 0, z.groove_z), z.d1 / 2, z.groove_r).Shape());
  return holed(s, 0, 0, z.bore_d, end - z.bore_depth, end + 1);
}

}  // namespace proveout::test

// The plate of milled_part.cpp as OpenCASCADE tessellates it: occt_plate CHORD FILE.stl. Not part of the
// build; see README.md beside it.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <StlAPI_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <cstdlib>

namespace {

gp_Ax2 upAt(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }

/// A block with its upright edges rounded.
TopoDS_Shape roundedBox(const gp_Pnt& low, const gp_Pnt& high, double radius) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(low, high).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer at(box, TopAbs_EDGE); at.More(); at.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(at.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (std::abs(a.Z() - b.Z()) > 1e-9) fillet.Add(radius, edge);
  }
  return fillet.Shape();
}

/// What a ball leaves on its way along X.
TopoDS_Shape ballSlot(double x0, double x1, double y, double z, double r) {
  const gp_Ax2 along(gp_Pnt(x0, y, z), gp_Dir(1, 0, 0));
  TopoDS_Shape out = BRepPrimAPI_MakeCylinder(along, r, x1 - x0).Shape();
  for (const double x : {x0, x1}) out = BRepAlgoAPI_Fuse(out, BRepPrimAPI_MakeSphere(upAt(x, y, z), r).Shape());
  return out;
}

/// Floor at -3, walls of radius 6, a fillet of 1 between.
TopoDS_Shape roundPocket(double x, double y) {
  const auto p = [&](double r, double z) { return gp_Pnt(x + r, y, z); };
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(p(0, 3), p(0, -3)));
  wire.Add(BRepBuilderAPI_MakeEdge(p(0, -3), p(5, -3)));
  const double c = std::sqrt(0.5);
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(p(5, -3), p(5 + c, -2 - c), p(6, -2)).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(p(6, -2), p(6, 3)));
  wire.Add(BRepBuilderAPI_MakeEdge(p(6, 3), p(0, 3)));
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()), gp_Ax1(gp_Pnt(x, y, 0), gp_Dir(0, 0, 1)));
}

TopoDS_Shape plate() {
  TopoDS_Shape s = BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -16), gp_Pnt(60, 40, -6)).Shape(),
                                    roundedBox(gp_Pnt(5, 5, -8), gp_Pnt(55, 35, 0), 5));
  const auto cut = [&](const TopoDS_Shape& tool) { s = BRepAlgoAPI_Cut(s, tool); };
  cut(roundedBox(gp_Pnt(14, 15, -4), gp_Pnt(30, 25, 3), 3));
  const double holes[4][2] = {{12, 11}, {48, 11}, {48, 29}, {12, 29}};
  for (const auto& at : holes) cut(BRepPrimAPI_MakeCylinder(upAt(at[0], at[1], -20), 2.5, 23).Shape());
  const double tip = 2.5 / std::tan(59.0 * M_PI / 180.0);
  cut(BRepPrimAPI_MakeCone(upAt(36, 11, -10), 0, 2.5, tip).Shape());
  cut(BRepPrimAPI_MakeCylinder(upAt(36, 11, -10 + tip), 2.5, 13 - tip).Shape());
  cut(ballSlot(20, 40, 31, 1, 3));
  cut(ballSlot(20, 30, 8.5, 2, 3));
  cut(roundPocket(43, 20));
  for (const double x : {12.0, 48.0}) cut(BRepPrimAPI_MakeCone(upAt(x, 11, -2), 2, 6, 4).Shape());
  return s;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  constexpr double kAngle = 0.5;  // rad: what FreeCAD and others leave it at
  const TopoDS_Shape shape = plate();
  BRepMesh_IncrementalMesh mesh(shape, std::atof(argv[1]), false, kAngle);
  StlAPI_Writer writer;
  writer.ASCIIMode() = false;
  return writer.Write(shape, argv[2]) ? 0 : 1;
}

#include "tests/unit/step/step_parts.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <stdexcept>

namespace proveout::test {
namespace {

gp_Ax2 upAt(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }
TopoDS_Shape without(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }

Handle(XCAFDoc_ShapeTool) newDocument(Handle(TDocStd_Document) & document) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  return XCAFDoc_DocumentTool::ShapeTool(document->Main());
}

void write(const Handle(TDocStd_Document) & document, const std::string& path, const char* unit) {
  STEPCAFControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", unit);
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  writer.Transfer(document, STEPControl_AsIs);
  if (writer.Write(path.c_str()) != IFSelect_RetDone) throw std::runtime_error("cannot write " + path);
}

}  // namespace

TopoDS_Shape plate(const PlateSizes& sizes) {
  const double r = sizes.through_radius;
  TopoDS_Shape s = BRepPrimAPI_MakeBox(100, 60, 20).Shape();
  s = without(s, BRepPrimAPI_MakeCylinder(upAt(20, 20, -1), r, 30).Shape());
  s = without(s, BRepPrimAPI_MakeCone(upAt(20, 20, 20 - r), r, 2 * r, r).Shape());
  s = without(
      s, BRepPrimAPI_MakeCylinder(upAt(sizes.blind_x, 30, 20 - sizes.blind_depth), sizes.blind_radius, 30)
             .Shape());
  s = without(s, BRepPrimAPI_MakeSphere(gp_Pnt(85, 30, 20), sizes.seat_radius).Shape());
  // A groove around (35, 45), by half a torus.
  return without(s, BRepPrimAPI_MakeTorus(upAt(35, 45, 20), 9, 3).Shape());
}

TopoDS_Shape turnedPart() {
  BRepBuilderAPI_MakePolygon outline;
  const double slope = 30.0 * std::tan(10.0 * M_PI / 180.0);
  for (const auto& [x, z] :
       std::vector<std::pair<double, double>>{{0, 0}, {20, 0}, {20, 50}, {20 - slope, 80}, {0, 80}})
    outline.Add(gp_Pnt(x, 0, z));
  outline.Close();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
  const TopoDS_Shape body = BRepPrimAPI_MakeRevol(face, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
  return without(body, BRepPrimAPI_MakeTorus(upAt(0, 0, 25), 20, 3).Shape());
}

TopoDS_Shape freeForm() {
  constexpr int kSide = 7;
  TColgp_Array2OfPnt points(1, kSide, 1, kSide);
  for (int i = 1; i <= kSide; ++i)
    for (int k = 1; k <= kSide; ++k) {
      const double x = -10.0 + 80.0 * (i - 1) / (kSide - 1), y = -10.0 + 60.0 * (k - 1) / (kSide - 1);
      points.SetValue(i, k, gp_Pnt(x, y, 20.0 + 2.0 * std::sin(x / 15.0) * std::cos(y / 12.0)));
    }
  const Handle(Geom_BSplineSurface) top = GeomAPI_PointsToBSplineSurface(points).Surface();
  const TopoDS_Face sheet = BRepBuilderAPI_MakeFace(top, 1e-6).Face();
  const TopoDS_Shape above = BRepPrimAPI_MakePrism(sheet, gp_Vec(0, 0, 40)).Shape();
  return without(BRepPrimAPI_MakeBox(60, 40, 30).Shape(), above);
}

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(60, 40, 10).Shape(); }

TopoDS_Shape pocketBlock() {
  const TopoDS_Shape pocket = without(block(), BRepPrimAPI_MakeCylinder(upAt(20, 20, 6), 8, 10).Shape());
  return without(pocket, BRepPrimAPI_MakeCylinder(upAt(45, 20, -1), 3, 20).Shape());
}

TopoDS_Shape openBox() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  int left = 5;
  for (TopExp_Explorer face(box, TopAbs_FACE); left > 0; face.Next(), --left)
    builder.Add(shell, face.Current());
  return shell;
}

void writeAssembly(const std::string& path) {
  Handle(TDocStd_Document) document;
  const Handle(XCAFDoc_ShapeTool) tool = newDocument(document);
  const auto part = [&](const TopoDS_Shape& shape, const char* name) {
    const TDF_Label label = tool->AddShape(shape, false);
    TDataStd_Name::Set(label, name);
    return label;
  };
  const TDF_Label base = part(BRepPrimAPI_MakeBox(30, 30, 5).Shape(), "base"),
                  pin = part(BRepPrimAPI_MakeCylinder(2, 10).Shape(), "pin"), whole = tool->NewShape();
  TDataStd_Name::Set(whole, "assembly");
  gp_Trsf up, turned;
  up.SetTranslation(gp_Vec(10, 10, 5));
  turned.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 0.5 * M_PI);
  tool->AddComponent(whole, base, TopLoc_Location());
  tool->AddComponent(whole, pin, TopLoc_Location(up));
  tool->AddComponent(whole, pin, TopLoc_Location(turned));
  tool->UpdateAssemblies();
  write(document, path, "MM");
}

void writeStep(const std::string& path, const std::vector<NamedShape>& shapes, const char* unit) {
  Handle(TDocStd_Document) document;
  const Handle(XCAFDoc_ShapeTool) tool = newDocument(document);
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  for (const NamedShape& named : shapes) {
    const TDF_Label label = tool->AddShape(named.shape, false);
    TDataStd_Name::Set(label, named.name.c_str());
    if (&named != shapes.data()) continue;
    const TopExp_Explorer face(named.shape, TopAbs_FACE);
    colours->SetColor(tool->AddSubShape(label, face.Current()), Quantity_Color(1, 0, 0, Quantity_TOC_RGB),
                      XCAFDoc_ColorSurf);
  }
  write(document, path, unit);
}

}  // namespace proveout::test

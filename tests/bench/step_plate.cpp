// step_plate COUNT FILE.step FILE.stl: a plate with COUNT times COUNT holes of five steps, ten faces each, as
// a STEP file and as its facets.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <IMeshTools_Parameters.hxx>
#include <STEPControl_Writer.hxx>
#include <StlAPI_Writer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <cstdlib>
#include <gp_Ax2.hxx>

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const int count = std::atoi(argv[1]);
  const double side = 12.0 * count + 8.0;
  TopTools_ListOfShape plate, holes;
  plate.Append(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -20), gp_Pnt(side, side, 0)).Shape());
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const double x = 10.0 + 12.0 * i, y = 10.0 + 12.0 * j;
      for (int k = 0; k < 5; ++k) {
        const gp_Ax2 axis(gp_Pnt(x, y, k == 0 ? -30.0 : -16.0 + 3.0 * k), gp_Dir(0, 0, 1));
        holes.Append(BRepPrimAPI_MakeCylinder(axis, 2.0 + 0.7 * k, 40.0).Shape());
      }
    }
  }
  BRepAlgoAPI_Cut cut;
  cut.SetArguments(plate);
  cut.SetTools(holes);
  cut.Build();
  STEPControl_Writer writer;
  if (writer.Transfer(cut.Shape(), STEPControl_AsIs) != IFSelect_RetDone) return 1;
  if (writer.Write(argv[2]) != IFSelect_RetDone) return 1;
  IMeshTools_Parameters mesh;
  mesh.MeshAlgo = IMeshTools_MeshAlgoType_Delabella;
  mesh.Deflection = 0.02;
  mesh.Angle = 0.3;
  BRepMesh_IncrementalMesh mesher(cut.Shape(), mesh);
  StlAPI_Writer stl;
  stl.ASCIIMode() = false;
  return stl.Write(cut.Shape(), argv[3]) ? 0 : 1;
}

// Parts made with OpenCASCADE and written as STEP files, for tests.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <utility>
#include <vector>

namespace proveout::test {

/// A plate of 100 x 60 x 20 from (0, 0, 0) with a through hole at (20, 20), countersunk by 45 degrees to
/// twice its radius, a blind hole of radius 10 and depth 10 at (60, 30), a ball seat of radius 8 whose centre
/// is (85, 30, 20), and a quarter of a torus as the fillet of a boss.
struct PlateSizes {
  double through_radius = 4.0, blind_radius = 10.0, blind_depth = 10.0, seat_radius = 8.0, blind_x = 60.0;
};
TopoDS_Shape plate(const PlateSizes& sizes = {});
/// Turned about Z: 80 long, radius 20 with a cone of 10 degrees and a groove with a round of radius 3.
TopoDS_Shape turnedPart();
/// A block of 60 x 40 whose top is a spline surface of about 4 mm height difference around Z 20.
TopoDS_Shape freeForm();
/// A block of 60 x 40 x 10 with a round pocket of radius 8 and depth 4 at (20, 20) and a hole of radius 3
/// through it at (45, 20).
TopoDS_Shape pocketBlock();
/// The same block without pocket and hole.
TopoDS_Shape block();
/// A box without its top.
TopoDS_Shape openBox();

struct NamedShape {
  std::string name;
  TopoDS_Shape shape;
};
/// Writes an assembly: a base of 30 x 30 x 5, and a pin of radius 2 and length 10 twice: upwards from (10,
/// 10, 5), and turned by 90 degrees about X at the origin.
void writeAssembly(const std::string& path);
/// Writes the shapes with their names, the first face of the first one in red. `unit`: "MM", "INCH".
void writeStep(const std::string& path, const std::vector<NamedShape>& shapes, const char* unit = "MM");

}  // namespace proveout::test

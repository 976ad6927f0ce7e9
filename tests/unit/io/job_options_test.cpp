// The blank and the output formats as the command line gives them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/job/job.h"
#include "mesh_text.h"
#include "temp_folder.h"

namespace proveout {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(StockOption, ReadsBoxes) {
  const auto spec = parseStockOption("box:0,-1.5,-20:80,80,1e1");
  ASSERT_TRUE(spec.ok()) << spec.error().message;
  EXPECT_EQ(std::get<BoxShape>(*spec).min, Vec3(0, -1.5, -20));
  EXPECT_EQ(std::get<BoxShape>(*spec).max, Vec3(80, 80, 10));
}

TEST(StockOption, ReadsCylindersAndTubes) {
  const auto cylinder = parseStockOption("cylinder:1,2,3:10:30");
  ASSERT_TRUE(cylinder.ok()) << cylinder.error().message;
  EXPECT_EQ(std::get<CylinderShape>(*cylinder).radius, 5);
  EXPECT_EQ(std::get<CylinderShape>(*cylinder).length, 30);
  EXPECT_EQ(std::get<CylinderShape>(*cylinder).axis, 2);
  const auto tube = parseStockOption("tube:1,2,3:10:6:30:x");
  ASSERT_TRUE(tube.ok()) << tube.error().message;
  EXPECT_EQ(std::get<CylinderShape>(*tube).base, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<CylinderShape>(*tube).inner_radius, 3);
  EXPECT_EQ(std::get<CylinderShape>(*tube).axis, 0);
}

TEST(StockOption, ReadsFiles) {
  const io_test::TempFolder folder;
  const std::string mesh = folder.write("a:b.stl", io_test::kAsciiStl), vdb = folder.write("a.vdb", "x");
  const auto spec = parseStockOption("mesh:" + mesh);
  ASSERT_TRUE(spec.ok()) << spec.error().message;
  EXPECT_EQ(std::get<MeshFile>(*spec).path, mesh);
  const auto shape = loadStockShape(*spec);
  ASSERT_TRUE(shape.ok());
  EXPECT_EQ(std::get<MeshShape>(*shape).mesh.triangles.size(), 4u);
  EXPECT_EQ(std::get<SavedStock>(*parseStockOption("vdb:" + vdb)).path, vdb);
  EXPECT_FALSE(loadStockShape(MeshFile{vdb, MeshUnit::kMillimetre}).ok());
}

TEST(StockOption, RefusesEverythingElse) {
  for (const char* bad : {"",
                          "box",
                          "box:",
                          "box:0,0,0",
                          "box:0,0,0:1,1",
                          "box:0,0,0:1,1,1:2",
                          "box:0,0,0:1,1,x",
                          "box:0,0,0:1,1,nan",
                          "box:0,0,0:1,1,inf",
                          "box:0,0,0:1,1,1e300",
                          "box:0,0,0:1,1, 1",
                          "box:0,0,0:1,1,0",
                          "box:5,0,0:1,1,1",
                          "ball:3",
                          "cylinder:0,0,0:10",
                          "cylinder:0,0,0:0:5",
                          "cylinder:0,0,0:10:-5",
                          "cylinder:0,0,0:10:5:w",
                          "cylinder:0,0,0:10:5:x:y",
                          "tube:0,0,0:10:10:5",
                          "tube:0,0,0:10:5",
                          "mesh:",
                          "mesh:/nowhere.stl",
                          "vdb:/tmp",
                          "Box:0,0,0:1,1,1"}) {
    EXPECT_FALSE(parseStockOption(bad).ok()) << bad;
  }
  EXPECT_THAT(parseStockOption("box:0,0,0:1,1").error().message, HasSubstr("box:x0,y0,z0:x1,y1,z1"));
  EXPECT_THAT(parseStockOption("mesh:/nowhere.stl").error().message, HasSubstr("there is no such file"));
}

TEST(OutputFormats, AreReadFromAList) {
  EXPECT_THAT(*parseOutputFormats("stl,stl-ascii,obj,ply,vdb"),
              ElementsAre(OutputFormat::kStl, OutputFormat::kStlAscii, OutputFormat::kObj, OutputFormat::kPly,
                          OutputFormat::kVdb));
  for (const OutputFormat format : {OutputFormat::kStl, OutputFormat::kStlAscii, OutputFormat::kObj,
                                    OutputFormat::kPly, OutputFormat::kVdb}) {
    EXPECT_EQ(*parseOutputFormat(outputFormatName(format)), format);
  }
  EXPECT_EQ(outputFormatExtension(OutputFormat::kStlAscii), "stl");
  for (const char* bad : {"", "stl,", ",stl", "stl,stl", "step", "STL"}) {
    EXPECT_FALSE(parseOutputFormats(bad).ok()) << bad;
  }
}

}  // namespace
}  // namespace proveout

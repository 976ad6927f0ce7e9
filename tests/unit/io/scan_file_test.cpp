// Scans from files.
#include "io/scan_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_text.h"

namespace proveout {
namespace {

using testing::HasSubstr;

std::string points(const std::string& rows, int count) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty double x\nproperty double y\nproperty double z\nend_header\n" + rows;
}

std::string messageOf(const Result<ScanFile>& scan) { return scan ? std::string() : scan.error().message; }

TEST(ScanFile, PointsNeedNoFaces) {
  const Result<ScanFile> scan = parseScan(points("1 2 3\n4 5 6.5\n1 2 3\n", 3), "PLY", "a.ply");
  ASSERT_TRUE(scan) << scan.error().message;
  EXPECT_FALSE(scan->meshed);
  ASSERT_EQ(scan->mesh.positions.size(), 3u);
  EXPECT_EQ(scan->mesh.positions[1], Eigen::Vector3f(4, 5, 6.5));
  MeshLoadOptions inch;
  inch.unit = MeshUnit::kInch;
  EXPECT_EQ(parseScan(points("1 0 0\n", 1), "ply", "a.ply", inch)->mesh.positions[0].x(), 25.4f);
  // With a count of faces of none, normals and colours behind the points, as scanners write them.
  const std::string rich =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty float "
      "nx\nproperty uchar red\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n1 2 3 0.5 "
      "200\n";
  EXPECT_EQ(parseScan(rich, "ply", "a.ply")->mesh.positions[0], Eigen::Vector3f(1, 2, 3));
}

TEST(ScanFile, BinaryPointsAreRead) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty "
      "float "
      "z\nend_header\n";
  const float values[] = {1.0f, 2.0f, 3.0f, -1.0f, -2.0f, -3.0f};
  text.append(reinterpret_cast<const char*>(values), sizeof values);
  const Result<ScanFile> scan = parseScan(text, "ply", "a.ply");
  ASSERT_TRUE(scan) << scan.error().message;
  ASSERT_EQ(scan->mesh.positions.size(), 2u);
  EXPECT_EQ(scan->mesh.positions[1], Eigen::Vector3f(-1, -2, -3));
}

TEST(ScanFile, OpenMeshesAreRead) {
  const Result<ScanFile> scan = parseScan(
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid s\n",
      "stl", "a.stl");
  ASSERT_TRUE(scan) << scan.error().message;
  EXPECT_TRUE(scan->meshed);
  EXPECT_EQ(scan->mesh.triangles.size(), 1u);
  EXPECT_TRUE(parseScan(io_test::kAsciiPly, "ply", "a.ply")->meshed);
}

TEST(ScanFile, BadOnesAreRefused) {
  EXPECT_THAT(messageOf(parseScan("", "ply", "a.ply")), HasSubstr("a.ply: is empty"));
  EXPECT_THAT(messageOf(parseScan(points("", 0), "ply", "a.ply")), HasSubstr("the scan has no points"));
  EXPECT_THAT(messageOf(parseScan(points("1 nan 3\n", 1), "ply", "a.ply")), HasSubstr("not a finite number"));
  EXPECT_THAT(messageOf(parseScan(points("1 2\n", 1), "ply", "a.ply")), HasSubstr("cut short"));
  EXPECT_THAT(messageOf(parseScan("1 2 3\n", "xyz", "a.xyz")), HasSubstr("must end in .ply or .stl"));
  EXPECT_FALSE(loadScan("no-such-file.ply"));
}

}  // namespace
}  // namespace proveout

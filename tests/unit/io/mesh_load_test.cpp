#include <gtest/gtest.h>

#include <cmath>

#include "io/mesh_io.h"
#include "mesh_text.h"
#include "temp_folder.h"

namespace proveout {
namespace {

using namespace io_test;

void expectTetrahedron(const Result<TriMesh>& mesh, double scale = 1.0) {
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->positions.size(), 4u);
  EXPECT_EQ(mesh->triangles.size(), 4u);
  EXPECT_TRUE(analyseTopology(*mesh).closedManifold());
  EXPECT_NEAR(meshVolume(*mesh), scale * scale * scale / 6.0, 1e-6 * scale * scale * scale);
}

TEST(LoadMesh, ReadsEveryFormat) {
  expectTetrahedron(parseMesh(binaryStl(tetrahedron()), "stl", "a.stl"));
  expectTetrahedron(parseMesh(kAsciiStl, "STL", "a.stl"));
  expectTetrahedron(parseMesh(kObj, "obj", "a.obj"));
  expectTetrahedron(parseMesh(kAsciiPly, "ply", "a.ply"));
}

TEST(LoadMesh, ReadsBinaryStlThatBeginsWithSolid) {
  expectTetrahedron(parseMesh(binaryStl(tetrahedron(), "solid from a CAD system"), "stl", "a.stl"));
}

TEST(LoadMesh, ReadsAsciiStlInOtherDress) {
  std::string text = "  \n" + kAsciiStl;
  for (char& c : text) c = static_cast<char>(std::toupper(c));
  expectTetrahedron(parseMesh(text, "stl", "a.stl"));
  std::string windows;
  for (const char c : kAsciiStl) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expectTetrahedron(parseMesh(windows, "stl", "a.stl"));
  // Normals are not needed; writers print NaN for those of slivers.
  expectTetrahedron(parseMesh(replaced(kAsciiStl, "normal 0 0 -1", "normal nan nan nan"), "stl", "a.stl"));
}

TEST(LoadMesh, JoinsSeveralSolids) {
  const auto mesh =
      parseMesh(kAsciiStl + replaced(kAsciiStl, "vertex 1 0 0", "vertex 5 0 0"), "stl", "a.stl");
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->triangles.size(), 8u);
}

TEST(LoadMesh, ScalesUnits) {
  MeshLoadOptions options;
  options.unit = MeshUnit::kInch;
  expectTetrahedron(parseMesh(kObj, "obj", "a.obj", options), 25.4);
  options.unit = MeshUnit::kMetre;
  expectTetrahedron(parseMesh(binaryStl(tetrahedron()), "stl", "a.stl", options), 1000.0);
  EXPECT_EQ(*parseMeshUnit("in"), MeshUnit::kInch);
  EXPECT_EQ(*parseMeshUnit("mm"), MeshUnit::kMillimetre);
  EXPECT_FALSE(parseMeshUnit("cubit").ok());
  for (const MeshUnit unit : {MeshUnit::kMillimetre, MeshUnit::kInch, MeshUnit::kMetre}) {
    EXPECT_EQ(*parseMeshUnit(meshUnitName(unit)), unit);
  }
}

TEST(LoadMesh, AcceptsAnOpenMesh) {
  TriMesh open = tetrahedron();
  open.triangles.pop_back();
  const auto mesh = parseMesh(binaryStl(open), "stl", "a.stl");
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(analyseTopology(*mesh).boundary_edges, 3u);
}

TEST(LoadMesh, ReadsBinaryPlyOfBothByteOrders) {
  // Written by hand from the format's description: vertices as doubles, an element to skip, a list with its
  // own types.
  for (const bool little : {true, false}) {
    std::string bytes =
        std::string("ply\r\nformat binary_") + (little ? "little" : "big") +
        "_endian 1.0\r\nelement vertex 4\r\nproperty double x\r\nproperty double y\r\n"
        "property double z\r\nelement material 1\r\nproperty short a\r\nproperty list int8 float b\r\n"
        "element face 4\r\nproperty list ushort uint vertex_index\r\nend_header\r\n";
    const auto put = [&](std::uint64_t bits, int size) {
      for (int i = 0; i < size; ++i)
        bytes += static_cast<char>(bits >> 8 * (little ? i : size - 1 - i) & 0xFF);
    };
    for (const auto& p : tetrahedron().positions) {
      for (int i = 0; i < 3; ++i) put(std::bit_cast<std::uint64_t>(static_cast<double>(p[i])), 8);
    }
    put(7, 2), put(2, 1), put(std::bit_cast<std::uint32_t>(1.5f), 4), put(0, 4);
    for (const auto& t : tetrahedron().triangles) {
      put(3, 2);
      for (const std::uint32_t corner : t) put(corner, 4);
    }
    expectTetrahedron(parseMesh(bytes, "ply", "a.ply"));
  }
}

double area(const TriMesh& mesh) { return meshArea(mesh); }

TEST(LoadMesh, CutsConcavePolygons) {
  // An L of area 3 as one face; a fan from its first corner would have another area.
  const std::string ell = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
  for (const char* face : {"f 1 2 3 4 5 6", "f 3 4 5 6 1 2", "f 4 5 6 1 2 3", "f 6 5 4 3 2 1"}) {
    const auto mesh = parseMesh(ell + face + "\n", "obj", "a.obj");
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_EQ(mesh->triangles.size(), 4u);
    EXPECT_NEAR(area(*mesh), 3.0, 1e-6) << face;
  }
}

TEST(LoadMesh, CutsACombInAnyPlane) {
  // Teeth of a comb: area = base 20 x 1 + 10 teeth of 1 x 3. Tilted so that no coordinate plane fits.
  std::vector<Vec2> outline = {{0, 0}, {20, 0}, {20, 4}};
  for (int tooth = 9; tooth >= 0; --tooth) {
    const double x = 2.0 * tooth + 1.0;
    if (tooth < 9) outline.push_back({x + 1.0, 1}), outline.push_back({x + 1.0, 4});
    if (tooth == 9) outline.back() = {20, 4};
    outline.push_back({x, 4}), outline.push_back({x, 1});
  }
  double expected = 0.0;
  std::string text, face = "f";
  const double c = std::cos(0.5), s = std::sin(0.5);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    expected += 0.5 * (p.x() * q.y() - p.y() * q.x());
    text += "v " + std::to_string(p.x() * c) + " " + std::to_string(p.y()) + " " + std::to_string(p.x() * s) +
            "\n";
    face += " " + std::to_string(i + 1);
  }
  const auto mesh = parseMesh(text + face + "\n", "obj", "a.obj");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->triangles.size(), outline.size() - 2);
  EXPECT_NEAR(area(*mesh), expected, 1e-4);
}

TEST(LoadMesh, KeepsPolygonsWithCornersOnAnEdgeClosed) {
  // A box whose top edge carries an extra corner in the faces on both sides of it.
  const auto mesh = parseMesh(
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 0 1 1\nv 1 0 1\n"
      "f 4 3 2 1\nf 5 9 6 7 8\nf 1 2 6 9 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
      "obj", "box.obj");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_TRUE(analyseTopology(*mesh).closedManifold());
  EXPECT_NEAR(meshVolume(*mesh), 2.0, 1e-9);
}

TEST(LoadMesh, ReadsTinyNumbersAsZeroAndSigns) {
  const auto mesh = parseMesh("v +1e-400 -1e-60 0\nv 1 0 0\nv 0 +1.5E0 0\nf 1 2 3\n", "obj", "a.obj");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->positions[0], Eigen::Vector3f(0, 0, 0));
  EXPECT_EQ(mesh->positions[2].y(), 1.5f);
}

TEST(LoadMesh, ReadsFromFiles) {
  const TempFolder folder;
  expectTetrahedron(loadMesh(folder.write("part.STL", kAsciiStl)));
  expectTetrahedron(loadMesh(folder.write("part.obj", kObj)));
}

}  // namespace
}  // namespace proveout

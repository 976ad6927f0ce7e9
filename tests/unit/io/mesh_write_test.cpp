#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <limits>
#include <random>

#include "io/mesh_io.h"
#include "io/sha256.h"
#include "mesh_text.h"
#include "temp_folder.h"

namespace proveout {
namespace {

using namespace io_test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Written {
  MeshFormat format;
  std::string name;
};
const std::vector<Written> kAll = {{MeshFormat::kStlBinary, "b.stl"}, {MeshFormat::kStlAscii, "a.stl"},
                                   {MeshFormat::kObj, "o.obj"},       {MeshFormat::kPly, "p.ply"},
                                   {MeshFormat::kThreeMf, "m.3mf"},   {MeshFormat::kGlb, "g.glb"}};

using Corner = std::array<std::uint32_t, 3>;
Corner bits(const Eigen::Vector3f& p) {
  return {std::bit_cast<std::uint32_t>(p.x()), std::bit_cast<std::uint32_t>(p.y()),
          std::bit_cast<std::uint32_t>(p.z())};
}

/// Corners of all triangles in order, as bits.
std::vector<Corner> corners(const TriMesh& mesh) {
  std::vector<Corner> out;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t corner : t) out.push_back(bits(mesh.positions[corner]));
  }
  return out;
}

/// Triangles between random points of many magnitudes.
TriMesh randomMesh(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> mantissa(-1.0f, 1.0f);
  std::uniform_int_distribution<int> exponent(-40, 17);
  TriMesh mesh;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const auto x = [&] { return std::ldexp(mantissa(random), exponent(random)); };
    mesh.positions.push_back({x(), x(), x()});
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  mesh.positions[0] = {std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(), -1e-38f};
  return mesh;
}

TEST(WriteMesh, HashesTheBytesThatItWrites) {
  TempFolder folder;
  TriMesh mesh;
  for (unsigned seed = 0; seed < 40; ++seed) {  // several pieces of the largest format
    const TriMesh more = randomMesh(seed);
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
    for (const auto& t : more.triangles) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  mesh.motion.assign(mesh.triangles.size(), 7);
  for (const TriMesh& written : {mesh, TriMesh{}}) {
    for (const auto& [format, name] : kAll) {
      const Result<std::string> hash = writeMeshHashed(written, folder.path(name), format);
      ASSERT_TRUE(hash.ok()) << name;
      EXPECT_EQ(*hash, *sha256OfFile(folder.path(name))) << name;
    }
  }
  EXPECT_FALSE(writeMeshHashed(mesh, folder.path("no/such/folder.stl"), MeshFormat::kStlBinary).ok());
}

TEST(WriteMesh, ComesBackBitForBit) {
  const TempFolder folder;
  const TriMesh mesh = randomMesh(1);
  for (const Written& w : kAll) {
    ASSERT_TRUE(writeMesh(mesh, folder.path(w.name), w.format).ok());
    const auto back = loadMesh(folder.path(w.name));
    ASSERT_TRUE(back.ok()) << back.error().message;
    EXPECT_EQ(corners(*back), corners(mesh)) << w.name;
  }
}

TEST(WriteMesh, IsReadByAnotherLibrary) {
  const TempFolder folder;
  const TriMesh mesh = tetrahedron();
  for (const Written& w : kAll) {
    ASSERT_TRUE(writeMesh(mesh, folder.path(w.name), w.format).ok());
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(folder.path(w.name), aiProcess_ValidateDataStructure);
    ASSERT_NE(scene, nullptr) << w.name << ": " << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 1u);
    const aiMesh& read = *scene->mMeshes[0];
    ASSERT_EQ(read.mNumFaces, mesh.triangles.size()) << w.name;
    for (unsigned f = 0; f < read.mNumFaces; ++f) {
      for (unsigned k = 0; k < 3; ++k) {
        const aiVector3D& p = read.mVertices[read.mFaces[f].mIndices[k]];
        EXPECT_EQ(Eigen::Vector3f(p.x, p.y, p.z), mesh.positions[mesh.triangles[f][k]]) << w.name;
      }
    }
  }
}

TEST(WriteMesh, WritesTheBytesOfTheStlFormat) {
  const TempFolder folder;
  ASSERT_TRUE(writeMesh(tetrahedron(), folder.path("b.stl"), MeshFormat::kStlBinary).ok());
  const std::string bytes = readBytes(folder.path("b.stl"));
  ASSERT_EQ(bytes.size(), 84u + 4 * 50);
  EXPECT_EQ(bytes.substr(0, 5), "prove");
  EXPECT_THAT(bytes.substr(0, 80), HasSubstr("unit mm"));
  // First triangle: in the plane z = 0, seen from below.
  EXPECT_EQ(bytes.substr(80, 16), std::string("\4\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\xbf", 16));
}

TEST(WriteMesh, KeepsMotionsInPly) {
  const TempFolder folder;
  TriMesh mesh = tetrahedron();
  mesh.motion = {5, 0xFFFFFFFF, 7, 100000};
  ASSERT_TRUE(writeMesh(mesh, folder.path("p.ply"), MeshFormat::kPly).ok());
  const auto back = loadMesh(folder.path("p.ply"));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->motion, mesh.motion);
}

TEST(WriteMesh, SameBytesForTheSameMesh) {
  const TempFolder folder;
  for (const Written& w : kAll) {
    ASSERT_TRUE(writeMesh(randomMesh(2), folder.path("1" + w.name), w.format).ok());
    ASSERT_TRUE(writeMesh(randomMesh(2), folder.path("2" + w.name), w.format).ok());
    EXPECT_EQ(readBytes(folder.path("1" + w.name)), readBytes(folder.path("2" + w.name)));
  }
}

TEST(WriteMesh, ReportsAFullDiskAndBadFolders) {
  const TempFolder folder;
  const std::string file = folder.write("file", "x");
  for (const Written& w : kAll) {
    EXPECT_THAT(writeMesh(tetrahedron(), "/dev/full", w.format).error().message, HasSubstr("No space left"));
    EXPECT_FALSE(writeMesh(tetrahedron(), file + "/a", w.format).ok());
    EXPECT_FALSE(writeMesh(tetrahedron(), "/proc/a", w.format).ok());
  }
  EXPECT_THAT(folder.names(), ElementsAre("file"));
}

TEST(WriteMesh, RefusesBrokenMeshesBeforeTheFileIsTouched) {
  const TempFolder folder;
  const std::string path = folder.write("part.stl", "earlier");
  TriMesh index = tetrahedron(), finite = tetrahedron(), motion = tetrahedron();
  index.triangles[1][2] = 4;
  finite.positions[0].x() = std::numeric_limits<float>::infinity();
  motion.motion = {1};
  for (const TriMesh& mesh : {index, finite, motion}) {
    EXPECT_FALSE(writeMesh(mesh, path, MeshFormat::kStlBinary).ok());
  }
  EXPECT_EQ(readBytes(path), "earlier");
}

}  // namespace
}  // namespace proveout

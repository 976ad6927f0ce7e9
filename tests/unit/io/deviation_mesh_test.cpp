// The mesh with deviations, as others read it: assimp, and a reader of the two headers of our own.
#include "io/exchange/deviation_mesh.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/mesh_io.h"
#include "io/sha256.h"
#include "mesh_text.h"
#include "temp_folder.h"

namespace proveout {
namespace {

using namespace io_test;
using ::testing::HasSubstr;

/// A tetrahedron: one vertex of the blank, the others by two blocks.
DeviationMesh sample() {
  DeviationMesh mesh;
  mesh.positions = tetrahedron().positions;
  mesh.triangles = tetrahedron().triangles;
  mesh.deviation = {0.0F, -0.125F, 0.0625F, 0.5F};
  mesh.colours = {{{230, 230, 224}}, {{0, 10, 255}}, {{255, 128, 0}}, {{200, 1, 2}}};
  mesh.made_by = {0, 1, 2, 2};
  mesh.blocks = {SurfaceBlock{}, SurfaceBlock{0, 3, 0, 12, 120}, SurfaceBlock{1, 7, 1, 16'777'217, -1}};
  mesh.files = {"main.nc", "sub 1.nc"};
  mesh.setups = {"top", "bottom"};
  mesh.gouge_mm = 0.02;
  mesh.excess_mm = 0.05;
  mesh.limit_mm = 0.5;
  return mesh;
}

/// Two vertices for the first one, and their order turned round.
ShadedVertices shaded() {
  ShadedVertices out;
  out.vertex = {3, 2, 1, 0, 0};
  out.normals.assign(5, Eigen::Vector3f(0, 0, 1));
  out.triangles = {{3, 1, 2}, {3, 2, 0}, {4, 0, 1}, {2, 1, 0}};
  return out;
}

std::uint32_t wordOf(const std::string& bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i)
    out |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return out;
}

TEST(DeviationPly, HoldsEachValueUnderItsName) {
  const TempFolder folder;
  const DeviationMesh mesh = sample();
  const Result<std::string> hash = writeDeviationPly(mesh, folder.path("d.ply"));
  ASSERT_TRUE(hash.ok());
  const std::string bytes = readBytes(folder.path("d.ply"));
  EXPECT_EQ(*hash, sha256Hex(bytes));
  const std::size_t body = bytes.find("end_header\n") + 11;
  const std::string head = bytes.substr(0, body);
  EXPECT_THAT(head, HasSubstr("comment file 1 sub 1.nc\n"));
  EXPECT_THAT(head, HasSubstr("comment setup 1 bottom\n"));
  // The row as its header declares it: 3 floats, 3 bytes, a float, 5 whole numbers.
  EXPECT_THAT(head,
              HasSubstr("property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                        "property float deviation\nproperty int line\nproperty int block\nproperty int "
                        "file\nproperty int tool\nproperty int setup\nelement face 4\n"));
  constexpr std::size_t kRow = 12 + 3 + 4 + 20;
  ASSERT_EQ(bytes.size(), body + 4 * kRow + 4 * 13);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t at = body + i * kRow;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::bit_cast<float>(wordOf(bytes, at + 4 * static_cast<std::size_t>(axis))),
                mesh.positions[i][axis]);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(static_cast<unsigned char>(bytes[at + 12 + k]), mesh.colours[i][k]);
    EXPECT_EQ(std::bit_cast<float>(wordOf(bytes, at + 15)), mesh.deviation[i]);
    const SurfaceBlock& by = mesh.blocks[mesh.made_by[i]];
    const std::int64_t told[] = {by.line, by.block, by.file, by.tool, by.setup};
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_EQ(static_cast<std::int32_t>(wordOf(bytes, at + 19 + 4 * k)), told[k]) << i << " " << k;
  }
}

TEST(DeviationPly, IsReadByAnotherLibraryAndByOurs) {
  const TempFolder folder;
  DeviationMesh mesh = sample();
  mesh.deviation[2] = std::numeric_limits<float>::quiet_NaN();
  ASSERT_TRUE(writeDeviationPly(mesh, folder.path("d.ply")).ok());
  const Result<TriMesh> ours = loadMesh(folder.path("d.ply"));
  ASSERT_TRUE(ours.ok()) << ours.error().message;
  EXPECT_EQ(ours->positions, mesh.positions);
  EXPECT_EQ(ours->triangles, mesh.triangles);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(folder.path("d.ply"), aiProcess_ValidateDataStructure);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const aiMesh& read = *scene->mMeshes[0];
  ASSERT_EQ(read.mNumVertices, 4u);
  for (unsigned i = 0; i < 4; ++i) {
    EXPECT_NEAR(255.0F * read.mColors[0][i].r, mesh.colours[i][0], 0.01);
    EXPECT_NEAR(255.0F * read.mColors[0][i].b, mesh.colours[i][2], 0.01);
    EXPECT_EQ(Eigen::Vector3f(read.mVertices[i].x, read.mVertices[i].y, read.mVertices[i].z),
              mesh.positions[i]);
  }
}

TEST(DeviationPly, LeavesBlocksOutWhereNoProgramIsKnown) {
  const TempFolder folder;
  DeviationMesh mesh = sample();
  mesh.made_by.clear();
  mesh.blocks.clear();
  mesh.files.clear();
  mesh.setups.clear();
  ASSERT_TRUE(writeDeviationPly(mesh, folder.path("d.ply")).ok());
  const std::string bytes = readBytes(folder.path("d.ply"));
  EXPECT_EQ(bytes.find("property int"), std::string::npos);
  EXPECT_EQ(bytes.size(), bytes.find("end_header\n") + 11 + 4 * 19 + 4 * 13);
}

/// The JSON part of a GLB, and the numbers of one attribute of its mesh.
class GlbCheck {
 public:
  explicit GlbCheck(std::string bytes) : bytes_(std::move(bytes)) {
    json = nlohmann::json::parse(bytes_.substr(20, wordOf(bytes_, 12)));
  }
  nlohmann::json json;
  bool has(const std::string& attribute) const { return attributes().contains(attribute); }
  std::vector<double> values(const std::string& attribute) const {
    const nlohmann::json& accessor = json["accessors"][attributes()[attribute].get<std::size_t>()];
    const nlohmann::json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::size_t at = 28 + wordOf(bytes_, 12) + view["byteOffset"].get<std::size_t>();
    const bool shorts = accessor["componentType"] == 5123;
    const std::size_t columns = accessor["type"] == "SCALAR" ? 1 : accessor["type"] == "VEC4" ? 4 : 3;
    std::vector<double> out;
    for (std::size_t k = 0; k < accessor["count"].get<std::size_t>() * columns; ++k) {
      out.push_back(shorts ? (wordOf(bytes_ + "\0\0", at) & 0xFFFF) / 65535.0
                           : std::bit_cast<float>(wordOf(bytes_, at)));
      at += shorts ? 2 : 4;
    }
    return out;
  }

 private:
  const nlohmann::json& attributes() const { return json["meshes"][0]["primitives"][0]["attributes"]; }
  std::string bytes_;
};

TEST(DeviationGlb, HoldsEachValueUnderItsName) {
  const TempFolder folder;
  const DeviationMesh mesh = sample();
  const ShadedVertices vertices = shaded();
  const Result<std::string> hash = writeDeviationGlb(mesh, vertices, folder.path("d.glb"));
  ASSERT_TRUE(hash.ok()) << hash.error().message;
  const std::string bytes = readBytes(folder.path("d.glb"));
  EXPECT_EQ(*hash, sha256Hex(bytes));
  const GlbCheck glb(bytes);
  const std::vector<double> deviation = glb.values("_DEVIATION"), line = glb.values("_LINE"),
                            tool = glb.values("_TOOL"), block = glb.values("_BLOCK"),
                            file = glb.values("_FILE"), setup = glb.values("_SETUP"),
                            colour = glb.values("COLOR_0");
  for (std::size_t i = 0; i < vertices.vertex.size(); ++i) {
    const std::uint32_t vertex = vertices.vertex[i];
    const SurfaceBlock& by = mesh.blocks[mesh.made_by[vertex]];
    EXPECT_EQ(deviation[i], mesh.deviation[vertex]);
    EXPECT_EQ(line[i], static_cast<float>(by.line));
    EXPECT_EQ(block[i], static_cast<float>(by.block));
    EXPECT_EQ(tool[i], by.tool);
    EXPECT_EQ(file[i], by.file);
    EXPECT_EQ(setup[i], by.setup);
    for (std::size_t k = 0; k < 3; ++k) {  // linear light, as glTF has it
      const double s = mesh.colours[vertex][k] / 255.0;
      EXPECT_NEAR(colour[4 * i + k], s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4), 1e-5);
    }
    EXPECT_EQ(colour[4 * i + 3], 1.0);
  }
  EXPECT_FALSE(glb.has("_MEASURED"));
  EXPECT_EQ(glb.json["meshes"][0]["extras"]["files"][1], "sub 1.nc");
  EXPECT_EQ(glb.json["meshes"][0]["extras"]["excess_mm"], 0.05);
}

TEST(DeviationGlb, HasNoNumberThatIsNone) {
  const TempFolder folder;
  DeviationMesh mesh = sample();
  mesh.deviation[2] = std::numeric_limits<float>::quiet_NaN();
  ASSERT_TRUE(writeDeviationGlb(mesh, shaded(), folder.path("d.glb")).ok());
  const GlbCheck glb(readBytes(folder.path("d.glb")));
  EXPECT_EQ(glb.values("_DEVIATION")[1], 0.0);
  EXPECT_EQ(glb.values("_MEASURED"), (std::vector<double>{1, 0, 1, 1, 1}));
}

TEST(DeviationGlb, IsReadByAnotherLibraryAndByOurs) {
  const TempFolder folder;
  const DeviationMesh mesh = sample();
  ASSERT_TRUE(writeDeviationGlb(mesh, shaded(), folder.path("d.glb")).ok());
  const Result<TriMesh> ours = loadMesh(folder.path("d.glb"));
  ASSERT_TRUE(ours.ok()) << ours.error().message;
  EXPECT_TRUE(analyseTopology(*ours).closedManifold());
  EXPECT_DOUBLE_EQ(meshVolume(*ours), 1.0 / 6.0);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(folder.path("d.glb"), aiProcess_ValidateDataStructure);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const aiMesh& read = *scene->mMeshes[0];
  ASSERT_EQ(read.mNumVertices, 5u);
  ASSERT_EQ(read.mNumFaces, 4u);
  EXPECT_TRUE(read.HasNormals() && read.HasVertexColors(0));
  EXPECT_EQ(read.mVertices[0].z, 1.0F);
}

TEST(DeviationFiles, ComeOutWholeOrNotAtAllAndAlwaysTheSame) {
  const TempFolder folder;
  for (const char* name : {"1", "2"}) {
    ASSERT_TRUE(writeDeviationPly(sample(), folder.path(std::string(name) + ".ply")).ok());
    ASSERT_TRUE(writeDeviationGlb(sample(), shaded(), folder.path(std::string(name) + ".glb")).ok());
  }
  EXPECT_EQ(readBytes(folder.path("1.ply")), readBytes(folder.path("2.ply")));
  EXPECT_EQ(readBytes(folder.path("1.glb")), readBytes(folder.path("2.glb")));
  EXPECT_THAT(writeDeviationPly(sample(), "/dev/full").error().message, HasSubstr("No space left"));
  EXPECT_THAT(writeDeviationGlb(sample(), shaded(), "/dev/full").error().message, HasSubstr("No space left"));
}

}  // namespace
}  // namespace proveout

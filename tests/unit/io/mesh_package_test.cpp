// 3MF and GLB: what is read of files by others, what is refused, and what others read of ours.
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <bit>
#include <functional>
#include <nlohmann/json.hpp>

#include "io/exchange/zip_archive.h"
#include "io/mesh_io.h"
#include "mesh_text.h"
#include "temp_folder.h"

namespace proveout {
namespace {

using namespace io_test;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i)
    out |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return out;
}

std::string words(const std::vector<std::uint32_t>& values) {
  std::string out;
  for (const std::uint32_t value : values) append32(out, value);
  return out;
}

std::string floats(const std::vector<float>& values) {
  std::string out;
  for (const float value : values) append32(out, std::bit_cast<std::uint32_t>(value));
  return out;
}

std::string glb(const Json& json, std::string binary) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto size = [](const std::string& bytes) { return static_cast<std::uint32_t>(bytes.size()); };
  return words({0x46546C67, 2, 28 + size(text) + size(binary), size(text), 0x4E4F534A}) + text +
         words({size(binary), 0x004E4942}) + binary;
}

/// A tetrahedron with legs of 0.001 m at the origin, and what a test changes.
std::string tetrahedronGlb(const std::function<void(Json&)>& change = {}) {
  const TriMesh mesh = tetrahedron();
  std::vector<float> positions;
  for (const auto& p : mesh.positions)
    positions.insert(positions.end(), {p.x() / 1000, p.y() / 1000, p.z() / 1000});
  std::vector<std::uint32_t> corners;
  for (const auto& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  Json json = {{"asset", {{"version", "2.0"}}},
               {"scene", 0},
               {"scenes", {{{"nodes", {0}}}}},
               {"nodes", {{{"mesh", 0}}}},
               {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
               {"accessors",
                {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
                 {{"bufferView", 1}, {"componentType", 5125}, {"count", 12}, {"type", "SCALAR"}}}},
               {"bufferViews",
                {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 48}},
                 {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 48}}}},
               {"buffers", {{{"byteLength", 96}}}}};
  if (change) change(json);
  return glb(json, floats(positions) + words(corners));
}

Box3 boundsOf(std::string_view bytes, const char* extension) {
  const Result<TriMesh> mesh = parseMesh(bytes, extension, "file");
  EXPECT_TRUE(mesh.ok()) << mesh.error().message;
  if (!mesh) return Box3();
  EXPECT_TRUE(analyseTopology(*mesh).closedManifold());
  EXPECT_GT(meshVolume(*mesh), 0.0);
  return meshBounds(*mesh);
}

void expectBox(const Box3& box, const Vec3& min, const Vec3& max) {
  constexpr double kRounding = 3e-7;  // of single precision
  EXPECT_LT((box.min - min).norm(), kRounding * (1.0 + min.norm())) << box.min.transpose();
  EXPECT_LT((box.max - max).norm(), kRounding * (1.0 + max.norm())) << box.max.transpose();
}

TEST(ReadGlb, TurnsMetresWithYUpIntoMillimetresWithZUp) {
  // The leg along +Y of the file points up: +Z here; that along +Z points to -Y.
  expectBox(boundsOf(tetrahedronGlb(), "glb"), {0, -1, 0}, {1, 0, 1});
  expectBox(boundsOf(tetrahedronGlb(), "GLB"), {0, -1, 0}, {1, 0, 1});
}

TEST(ReadGlb, PlacesMeshesAsTheirNodesSay) {
  const std::string placed = tetrahedronGlb([](Json& json) {
    // 2 x along X, then a quarter turn about Y (X to -Z), then a shift; below a node that shifts by 1 m in X.
    json["nodes"] = {{{"translation", {1, 0, 0}}, {"children", {1}}},
                     {{"mesh", 0},
                      {"scale", {2, 1, 1}},
                      {"rotation", {0, 0.70710678118654752, 0, 0.70710678118654752}},
                      {"translation", {0, 0.005, 0}}}};
  });
  // In the file: x = z of the mesh + 1 m, y = y + 5 mm, z = -2 x; here (x, -z, y).
  expectBox(boundsOf(placed, "glb"), {1000, 0, 5}, {1001, 2, 6});
  const std::string mirrored = tetrahedronGlb(
      [](Json& json) { json["nodes"][0]["matrix"] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; });
  expectBox(boundsOf(mirrored, "glb"), {-1, -1, 0}, {0, 0, 1});  // and outward still
  const std::string twice = tetrahedronGlb([](Json& json) {
    json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0.01, 0, 0}}}};
    json["scenes"][0]["nodes"] = {0, 1};
  });
  expectBox(boundsOf(twice, "glb"), {0, -1, 0}, {11, 0, 1});
}

TEST(ReadGlb, ReadsShortIndicesAndRowsWithAStride) {
  std::string binary;
  for (const auto& p : tetrahedron().positions) binary += floats({p.x(), p.y(), p.z(), 99.0F});
  for (const auto& t : tetrahedron().triangles) {
    for (const std::uint32_t corner : t) binary += static_cast<char>(corner);
  }
  Json json = {{"asset", {{"version", "2.0"}}},
               {"scenes", {{{"nodes", {0}}}}},
               {"nodes", {{{"mesh", 0}}}},
               {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
               {"accessors",
                {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
                 {{"bufferView", 1}, {"componentType", 5121}, {"count", 12}, {"type", "SCALAR"}}}},
               {"bufferViews",
                {{{"buffer", 0}, {"byteLength", 64}, {"byteStride", 16}},
                 {{"buffer", 0}, {"byteOffset", 64}, {"byteLength", 12}}}},
               {"buffers", {{{"byteLength", 76}}}}};
  expectBox(boundsOf(glb(json, binary), "glb"), {0, -1000, 0}, {1000, 0, 1000});
}

struct BadGlb {
  const char* what;  ///< of the message
  std::function<void(Json&)> change;
};

TEST(ReadGlb, RefusesWhatIsNoWholeMesh) {
  const std::vector<BadGlb> bad = {
      {"points or lines", [](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 1; }},
      {"strips or fans", [](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 5; }},
      {"reaches beyond its data", [](Json& j) { j["accessors"][0]["count"] = 5; }},
      {"reaches beyond its data", [](Json& j) { j["bufferViews"][1]["byteLength"] = 52; }},
      {"reaches beyond its data", [](Json& j) { j["bufferViews"][0]["byteOffset"] = 18446744073709551615u; }},
      {"reaches beyond its data", [](Json& j) { j["accessors"][0]["count"] = 9223372036854775807u; }},
      {"not whole", [](Json& j) { j["accessors"][1]["count"] = 11; }},
      {"index out of range", [](Json& j) { j["accessors"][0]["count"] = 3; }},
      {"of a kind", [](Json& j) { j["accessors"][0]["componentType"] = 5123; }},
      {"of a kind", [](Json& j) { j["accessors"][1]["type"] = "VEC2"; }},
      {"another file", [](Json& j) { j["buffers"][0]["uri"] = "part.bin"; }},
      {"KHR_draco_mesh_compression",
       [](Json& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }},
      {"below itself", [](Json& j) { j["nodes"][0]["children"] = {0}; }},
      {"there is no nodes 7", [](Json& j) { j["scenes"][0]["nodes"] = {7}; }},
      {"no mesh in its scene", [](Json& j) { j["nodes"][0].erase("mesh"); }},
      {"no scene", [](Json& j) { j.erase("scenes"); }},
      {"bones", [](Json& j) { j["nodes"][0]["skin"] = 0; }},
      {"morph",
       [](Json& j) {
         j["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
       }},
      {"no unit quaternion",
       [](Json& j) {
         j["nodes"][0]["rotation"] = {0, 0, 0, 2};
       }},
      {"must hold 16 numbers",
       [](Json& j) {
         j["nodes"][0]["matrix"] = {1, 2};
       }},
      {"must be a list", [](Json& j) { j["nodes"] = 3; }},
      {"whole number", [](Json& j) { j["nodes"][0]["mesh"] = -1; }},
      {"sparse", [](Json& j) { j["accessors"][0].erase("bufferView"); }},
      {"without positions",
       [](Json& j) { j["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }}};
  for (const auto& [what, change] : bad) {
    const Result<TriMesh> mesh = parseMesh(tetrahedronGlb(change), "glb", "a.glb");
    ASSERT_FALSE(mesh.ok()) << what;
    EXPECT_THAT(mesh.error().message, HasSubstr(what));
    EXPECT_THAT(mesh.error().message, HasSubstr("a.glb: "));
  }
}

TEST(ReadGlb, RefusesEveryFileThatIsCutShortAndAnyOtherContent) {
  const std::string whole = tetrahedronGlb();
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_FALSE(parseMesh(whole.substr(0, size), "glb", "a.glb").ok()) << size;
  EXPECT_FALSE(parseMesh(whole + "x", "glb", "a.glb").ok());
  EXPECT_THAT(parseMesh("solid x", "glb", "a.glb").error().message, HasSubstr("does not begin with glTF"));
  std::string nan = whole;
  nan.replace(nan.size() - 96, 4, floats({std::numeric_limits<float>::quiet_NaN()}));
  EXPECT_THAT(parseMesh(nan, "glb", "a.glb").error().message, HasSubstr("not finite"));
}

constexpr const char* kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const std::string kMesh =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
    "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/></triangles></mesh>";

std::string package(const std::string& model, const std::string& target = "/3D/part.model") {
  ZipWriter zip;
  zip.begin("_rels/.rels");
  zip.write(
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
      "Id=\"r\" "
      "Target=\"" +
      target + "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>");
  zip.begin("3D/part.model");
  zip.write(model);
  return *zip.finish();
}

std::string model(const std::string& attributes, const std::string& resources, const std::string& build) {
  return std::string("<?xml version=\"1.0\"?><model xmlns=\"") + kCore + "\" " + attributes + "><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

std::string object(const std::string& content, const std::string& attributes = "id=\"1\"") {
  return "<object " + attributes + ">" + content + "</object>";
}

const std::string kItem = "<item objectid=\"1\"/>";

TEST(ReadThreeMf, ReadsEveryUnit) {
  const std::vector<std::pair<std::string, double>> units = {{"", 1.0},
                                                             {"unit=\"millimeter\"", 1.0},
                                                             {"unit=\"inch\"", 25.4},
                                                             {"unit=\"micron\"", 0.001},
                                                             {"unit=\"centimeter\"", 10.0},
                                                             {"unit=\"foot\"", 304.8},
                                                             {"unit=\"meter\"", 1000.0}};
  for (const auto& [unit, size] : units)
    expectBox(boundsOf(package(model(unit, object(kMesh), kItem)), "3mf"), Vec3::Zero(),
              Vec3::Constant(size));
}

TEST(ReadThreeMf, PlacesObjectsAsItemsAndComponentsSay) {
  const std::string both =
      object(kMesh) + object(
                          "<components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 10 0 0\"/>"
                          "<component objectid=\"1\"/></components>",
                          "id=\"2\"");
  // Rows in front of the matrix: X to Y, Y to -X, and then shifted.
  const std::string turned = "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 5\"/>";
  expectBox(boundsOf(package(model("", both, turned)), "3mf"), {-1, 0, 5}, {0, 11, 6});
  const std::string mirrored = "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>";
  expectBox(boundsOf(package(model("", object(kMesh), mirrored)), "3mf"), {-1, 0, 0}, {0, 1, 1});
  const std::string support = object(kMesh) + object(kMesh, "id=\"3\" type=\"support\"");
  const std::string beside = kItem + "<item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 50 0 0\"/>";
  expectBox(boundsOf(package(model("", support, beside)), "3mf"), Vec3::Zero(), Vec3::Ones());
}

TEST(ReadThreeMf, RefusesWhatIsNoWholeMesh) {
  const auto swapped = [](const std::string& from, const std::string& to) {
    return package(model("", object(replaced(kMesh, from, to)), kItem));
  };
  const std::string beams =
      "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" requiredextensions=\"b\"";
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"index out of range: 9", swapped("v3=\"1\"/>", "v3=\"9\"/>")},
      {"'v3' is no whole number", swapped("v3=\"1\"/>", "v3=\"-1\"/>")},
      {"x is no number", swapped("x=\"1\"", "x=\"one\"")},
      {"not finite", swapped("x=\"1\"", "x=\"nan\"")},
      {"not finite", swapped("x=\"1\"", "x=\"1e99\"")},
      {"unknown unit 'furlong'", package(model("unit=\"furlong\"", object(kMesh), kItem))},
      {"beamlattice", package(model(beams, object(kMesh), kItem))},
      {"no object 4", package(model("", object(kMesh), "<item objectid=\"4\"/>"))},
      {"there twice", package(model("", object(kMesh) + object(kMesh), kItem))},
      {"builds nothing", package(model("", object(kMesh), ""))},
      {"12 numbers", package(model("", object(kMesh), "<item objectid=\"1\" transform=\"1 0 0\"/>"))},
      {"without an end",
       package(model("", object("<components><component objectid=\"1\"/></components>"), kItem))},
      {"line 1 of its model", package("<model><a></model>")},
      {"document type", package("<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b \"c\">]>" +
                                model("", object(kMesh), kItem).substr(21))},
      {"has no part '3D/other.model'", package(model("", object(kMesh), kItem), "/3D/other.model")},
      {"another model of the package",
       package(model("xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"",
                     object(kMesh), "<item objectid=\"1\" p:path=\"/3D/b.model\"/>"))},
      {"no ZIP archive", "PK not really"},
  };
  for (const auto& [what, bytes] : bad) {
    const Result<TriMesh> mesh = parseMesh(bytes, "3mf", "a.3mf");
    ASSERT_FALSE(mesh.ok()) << what;
    EXPECT_THAT(mesh.error().message, HasSubstr(what));
  }
}

TEST(ReadThreeMf, RefusesModelsOfCopiesWithoutNumber) {
  std::string objects = object(kMesh);
  for (int id = 2; id < 60; ++id) {
    const std::string part = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    objects += object("<components>" + part + part + "</components>", "id=\"" + std::to_string(id) + "\"");
  }
  const auto mesh = parseMesh(package(model("", objects, "<item objectid=\"59\"/>")), "3mf", "a.3mf");
  ASSERT_FALSE(mesh.ok());
  EXPECT_THAT(mesh.error().message, HasSubstr("with all copies"));
}

TEST(ReadThreeMf, RefusesPackagesThatAreCutShortOrDamaged) {
  const std::string whole = package(model("", object(kMesh), kItem));
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_FALSE(parseMesh(whole.substr(0, size), "3mf", "a.3mf").ok()) << size;
  const std::string text = model("", object(kMesh), kItem);
  for (std::size_t size = 0; size < text.size(); size += 7)
    EXPECT_FALSE(parseMesh(package(text.substr(0, size)), "3mf", "a.3mf").ok()) << size;
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 0x55);
  EXPECT_FALSE(parseMesh(damaged, "3mf", "a.3mf").ok());
}

TEST(StatesUnit, OfNames) {
  EXPECT_TRUE(statesUnit("a/b.3MF") && statesUnit("b.glb") && statesUnit("b.stp"));
  EXPECT_FALSE(statesUnit("glb.stl") || statesUnit("3mf") || statesUnit("a.3mf.ply"));
}

/// What the file says, held against what it holds.
void checkGlbStructure(const std::string& bytes) {
  ASSERT_EQ(word(bytes, 8), bytes.size());
  const std::uint32_t json_size = word(bytes, 12);
  ASSERT_EQ(json_size % 4, 0u);
  const Json json = Json::parse(bytes.substr(20, json_size));
  const std::size_t binary = 28 + json_size;
  const std::uint32_t binary_size = word(bytes, 20 + json_size);
  ASSERT_EQ(binary + binary_size, bytes.size());
  EXPECT_EQ(json["buffers"][0]["byteLength"], binary_size);
  for (const Json& accessor : json["accessors"]) {
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t offset = view["byteOffset"];
    const int kind = accessor["componentType"];
    const std::size_t columns = accessor["type"] == "VEC3" ? 3 : accessor["type"] == "VEC4" ? 4 : 1;
    const std::size_t row = columns * (kind == 5123 ? 2 : 4);
    EXPECT_EQ(offset % 4, 0u);
    EXPECT_EQ(row % 4, 0u);
    EXPECT_EQ(view["byteLength"], row * accessor["count"].get<std::size_t>());
    EXPECT_LE(offset + view["byteLength"].get<std::size_t>(), binary_size);
    if (!accessor.contains("min")) continue;
    for (std::size_t c = 0; c < columns; ++c) {
      float low = INFINITY, high = -INFINITY;
      for (std::size_t i = 0; i < accessor["count"]; ++i) {
        const float value = std::bit_cast<float>(word(bytes, binary + offset + i * row + 4 * c));
        low = std::min(low, value);
        high = std::max(high, value);
      }
      EXPECT_EQ(accessor["min"][c].get<float>(), low);
      EXPECT_EQ(accessor["max"][c].get<float>(), high);
    }
  }
}

TEST(WriteGlb, IsWhatItsHeaderSays) {
  const TempFolder folder;
  ASSERT_TRUE(writeMesh(tetrahedron(), folder.path("a.glb"), MeshFormat::kGlb).ok());
  checkGlbStructure(readBytes(folder.path("a.glb")));
}

TEST(WriteGlb, StandsUprightInMetresForOthers) {
  const TempFolder folder;
  ASSERT_TRUE(writeMesh(tetrahedron(), folder.path("a.glb"), MeshFormat::kGlb).ok());
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(folder.path("a.glb"), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  const aiNode* node = scene->mRootNode;
  while (node->mNumMeshes == 0) node = node->mChildren[0];
  aiMatrix4x4 world = node->mTransformation;
  for (const aiNode* above = node->mParent; above != nullptr; above = above->mParent)
    world = above->mTransformation * world;
  const aiVector3D top = world * aiVector3D(0, 0, 1), back = world * aiVector3D(0, 1, 0);
  EXPECT_NEAR(top.y, 0.001, 1e-9);
  EXPECT_NEAR(back.z, -0.001, 1e-9);
}

TEST(WritePackages, OfNothingIsReadAsNothing) {
  const TempFolder folder;
  for (const auto& [name, format] :
       {std::pair("a.glb", MeshFormat::kGlb), std::pair("a.3mf", MeshFormat::kThreeMf)}) {
    ASSERT_TRUE(writeMesh(TriMesh{}, folder.path(name), format).ok());
    EXPECT_FALSE(loadMesh(folder.path(name)).ok());
  }
}

}  // namespace
}  // namespace proveout

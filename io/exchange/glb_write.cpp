#include <algorithm>
#include <bit>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/exchange/glb_model.h"

namespace proveout {
namespace {

using GlbJson = nlohmann::ordered_json;

void putGlbWord(std::string& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(word >> shift & 0xFF);
}

std::uint64_t rowBytes(const GlbArray& array) {
  const std::uint64_t size = array.number == GlbNumber::kUnsignedShort ? 2 : 4;
  return size * static_cast<std::uint64_t>(array.columns);
}

std::uint64_t paddedBytes(const GlbArray& array) { return (rowBytes(array) * array.rows + 3) / 4 * 4; }

constexpr std::uint32_t kVertices = 34962, kCorners = 34963;  // targets of buffer views

/// mm with +Z up into metres with +Y up, by columns.
GlbJson upright() { return GlbJson::array({0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1}); }

const char* shapeOf(const GlbArray& array) {
  return array.columns == 1 ? "SCALAR" : array.columns == 3 ? "VEC3" : "VEC4";
}

GlbJson accessorOf(const GlbArray& array, std::size_t view) {
  GlbJson out = {{"bufferView", view},
                 {"componentType", static_cast<int>(array.number)},
                 {"count", array.attribute.empty() ? 3 * array.rows : array.rows},
                 {"type", array.attribute.empty() ? "SCALAR" : shapeOf(array)}};
  if (array.normalized) out["normalized"] = true;
  if (!array.min.empty()) out["min"] = array.min;
  if (!array.max.empty()) out["max"] = array.max;
  return out;
}

/// The arrays of a model in the order of the file.
std::vector<const GlbArray*> arraysOf(const GlbModel& model) {
  std::vector<const GlbArray*> arrays;
  for (const GlbArray& array : model.attributes) arrays.push_back(&array);
  arrays.push_back(&model.corners);
  return arrays;
}

GlbJson emptyScene() {
  return {{"asset", {{"version", "2.0"}, {"generator", "proveout"}}},
          {"scene", 0},
          {"scenes", GlbJson::array({{{"name", "part"}}})}};
}

/// The material is a diffuse one: a metal without surroundings to reflect is black in most viewers.
GlbJson materialOf(const GlbModel& model) {
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", {model.colour[0], model.colour[1], model.colour[2], 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", 0.6}}}};
}

GlbJson describeModel(const GlbModel& model) {
  GlbJson out = emptyScene();
  GlbJson views = GlbJson::array(), accessors = GlbJson::array(), attributes = GlbJson::object();
  std::uint64_t offset = 0;
  for (const GlbArray* array : arraysOf(model)) {
    const bool corners = array->attribute.empty();
    if (!corners) attributes[array->attribute] = accessors.size();
    accessors.push_back(accessorOf(*array, views.size()));
    views.push_back({{"buffer", 0},
                     {"byteOffset", offset},
                     {"byteLength", rowBytes(*array) * array->rows},
                     {"target", corners ? kCorners : kVertices}});
    offset += paddedBytes(*array);
  }
  out["scenes"][0]["nodes"] = {0};
  out["nodes"] = GlbJson::array({{{"name", model.name}, {"mesh", 0}, {"matrix", upright()}}});
  GlbJson primitive = {{"attributes", attributes}, {"indices", accessors.size() - 1}, {"material", 0}};
  out["meshes"] = GlbJson::array({{{"name", model.name}, {"primitives", GlbJson::array({primitive})}}});
  if (!model.extras.empty()) out["meshes"][0]["extras"] = GlbJson::parse(model.extras);
  out["materials"] = GlbJson::array({materialOf(model)});
  out["accessors"] = std::move(accessors);
  out["bufferViews"] = std::move(views);
  out["buffers"] = GlbJson::array({{{"byteLength", offset}}});
  return out;
}

void writeArray(const GlbArray& array, HashedFile& file) {
  constexpr std::size_t kRows = 1u << 15;
  std::string piece;
  for (std::size_t row = 0; row < array.rows; row += kRows) {
    piece.clear();
    array.append(row, std::min(array.rows, row + kRows), piece);
    file.write(piece);
  }
  file.write(std::string(paddedBytes(array) - rowBytes(array) * array.rows, '\0'));
}

constexpr std::uint32_t kGlbMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

}  // namespace

Result<std::string> writeGlb(const GlbModel& model, const std::string& path) {
  const bool empty = model.corners.rows == 0;
  std::string json =
      (empty ? emptyScene() : describeModel(model)).dump(-1, ' ', false, GlbJson::error_handler_t::replace);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::uint64_t binary = 0;
  for (const GlbArray* array : arraysOf(model)) binary += empty ? 0 : paddedBytes(*array);
  const std::uint64_t total = 12 + 8 + json.size() + (empty ? 0 : 8 + binary);
  if (total > std::numeric_limits<std::uint32_t>::max())
    return inputError(path + ": more than the 4 GiB that GLB can count; take PLY, or a coarser grid");
  Result<HashedFile> file = HashedFile::create(path);
  if (!file) return file.error();
  std::string head;
  for (const std::uint32_t word : {kGlbMagic, std::uint32_t{2}, static_cast<std::uint32_t>(total),
                                   static_cast<std::uint32_t>(json.size()), kJsonChunk})
    putGlbWord(head, word);
  head += json;
  if (!empty) {
    putGlbWord(head, static_cast<std::uint32_t>(binary));
    putGlbWord(head, kBinaryChunk);
  }
  file->write(head);
  for (const GlbArray* array : arraysOf(model)) {
    if (!empty) writeArray(*array, *file);
  }
  return file->commit();
}

GlbArray glbVectors(std::string attribute, const std::vector<Eigen::Vector3f>& rows) {
  GlbArray out;
  out.attribute = std::move(attribute);
  out.columns = 3;
  out.rows = rows.size();
  out.append = [&rows](std::size_t first, std::size_t last, std::string& bytes) {
    for (std::size_t i = first; i < last; ++i) {
      for (int axis = 0; axis < 3; ++axis) putGlbWord(bytes, std::bit_cast<std::uint32_t>(rows[i][axis]));
    }
  };
  return out;
}

GlbArray glbPositions(const std::vector<Eigen::Vector3f>& positions) {
  GlbArray out = glbVectors("POSITION", positions);
  if (positions.empty()) return out;
  Eigen::Vector3f low = positions[0], high = positions[0];
  for (const Eigen::Vector3f& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (int axis = 0; axis < 3; ++axis) {
    out.min.push_back(low[axis]);
    out.max.push_back(high[axis]);
  }
  return out;
}

GlbArray glbCorners(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  GlbArray out;
  out.number = GlbNumber::kUnsignedInt;
  out.columns = 3;
  out.rows = triangles.size();
  out.append = [&triangles](std::size_t first, std::size_t last, std::string& bytes) {
    for (std::size_t t = first; t < last; ++t) {
      for (const std::uint32_t corner : triangles[t]) putGlbWord(bytes, corner);
    }
  };
  return out;
}

Result<std::string> writePartGlb(const TriMesh& mesh, const std::string& path) {
  GlbModel model;
  model.name = "part";
  model.attributes.push_back(glbPositions(mesh.positions));
  model.corners = glbCorners(mesh.triangles);
  model.extras = R"({"unit": "mm", "up": "Z"})";
  model.colour = {0.45F, 0.47F, 0.5F};
  return writeGlb(model, path);
}

}  // namespace proveout

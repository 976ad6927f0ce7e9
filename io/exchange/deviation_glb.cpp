#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "core/base/printable.h"
#include "io/exchange/deviation_mesh.h"
#include "io/exchange/glb_model.h"

namespace proveout {
namespace {

/// 16 bits of linear light of an sRGB byte.
std::array<std::uint16_t, 256> linearWords() {
  std::array<std::uint16_t, 256> out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double s = static_cast<double>(i) / 255.0;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    out[i] = static_cast<std::uint16_t>(std::lround(65535.0 * linear));
  }
  return out;
}

GlbArray glbColours(const DeviationMesh& mesh, const ShadedVertices& shaded) {
  GlbArray out;
  out.attribute = "COLOR_0";
  out.number = GlbNumber::kUnsignedShort;
  out.columns = 4;
  out.normalized = true;
  out.rows = shaded.vertex.size();
  out.append = [&mesh, &shaded, linear = linearWords()](std::size_t first, std::size_t last,
                                                        std::string& bytes) {
    const auto put = [&](std::uint16_t word) {
      bytes += static_cast<char>(word & 0xFF);
      bytes += static_cast<char>(word >> 8);
    };
    for (std::size_t i = first; i < last; ++i) {
      for (const std::uint8_t share : mesh.colours[shaded.vertex[i]]) put(linear[share]);
      put(std::numeric_limits<std::uint16_t>::max());
    }
  };
  return out;
}

/// One float a vertex of the mesh.
GlbArray glbValues(std::string attribute, const ShadedVertices& shaded,
                   std::function<float(std::uint32_t vertex)> value) {
  GlbArray out;
  out.attribute = std::move(attribute);
  out.rows = shaded.vertex.size();
  out.append = [&shaded, value = std::move(value)](std::size_t first, std::size_t last, std::string& bytes) {
    for (std::size_t i = first; i < last; ++i) {
      const auto word = std::bit_cast<std::uint32_t>(value(shaded.vertex[i]));
      for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
    }
  };
  return out;
}

std::string glbExtras(const DeviationMesh& mesh) {
  nlohmann::ordered_json out = {{"unit", "mm"},
                                {"up", "Z"},
                                {"gouge_mm", mesh.gouge_mm},
                                {"excess_mm", mesh.excess_mm},
                                {"colour_limit_mm", mesh.limit_mm}};
  const auto names = [](const std::vector<std::string>& texts) {
    std::vector<std::string> shown;
    for (const std::string& text : texts) shown.push_back(printable(text));
    return shown;
  };
  if (!mesh.made_by.empty()) {
    out["files"] = names(mesh.files);
    out["setups"] = names(mesh.setups);
  }
  return out.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void addBlockColumns(const DeviationMesh& mesh, const ShadedVertices& shaded, GlbModel& model) {
  const auto add = [&](const char* attribute, std::int64_t (*of)(const SurfaceBlock&)) {
    model.attributes.push_back(glbValues(attribute, shaded, [&mesh, of](std::uint32_t vertex) {
      return static_cast<float>(of(mesh.blocks[mesh.made_by[vertex]]));
    }));
  };
  add("_LINE", [](const SurfaceBlock& by) { return std::int64_t{by.line}; });
  add("_BLOCK", [](const SurfaceBlock& by) { return by.block; });
  add("_FILE", [](const SurfaceBlock& by) { return std::int64_t{by.file}; });
  add("_TOOL", [](const SurfaceBlock& by) { return std::int64_t{by.tool}; });
  add("_SETUP", [](const SurfaceBlock& by) { return std::int64_t{by.setup}; });
}

}  // namespace

Result<std::string> writeDeviationGlb(const DeviationMesh& mesh, const ShadedVertices& shaded,
                                      const std::string& path) {
  PROVEOUT_ASSERT(shaded.normals.size() == shaded.vertex.size());
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(shaded.vertex.size());
  for (const std::uint32_t vertex : shaded.vertex) positions.push_back(mesh.positions[vertex]);
  GlbModel model;
  model.name = "part";
  model.attributes.push_back(glbPositions(positions));
  model.attributes.push_back(glbVectors("NORMAL", shaded.normals));
  model.attributes.push_back(glbColours(mesh, shaded));
  const auto measured = [&mesh](std::uint32_t vertex) { return std::isfinite(mesh.deviation[vertex]); };
  model.attributes.push_back(glbValues("_DEVIATION", shaded, [&mesh, measured](std::uint32_t vertex) {
    return measured(vertex) ? mesh.deviation[vertex] : 0.0F;
  }));
  const bool whole = std::all_of(mesh.deviation.begin(), mesh.deviation.end(),
                                 [](float deviation) { return std::isfinite(deviation); });
  if (!whole) {
    model.attributes.push_back(glbValues(
        "_MEASURED", shaded, [measured](std::uint32_t vertex) { return measured(vertex) ? 1.0F : 0.0F; }));
  }
  if (!mesh.made_by.empty()) addBlockColumns(mesh, shaded, model);
  model.corners = glbCorners(shaded.triangles);
  model.extras = glbExtras(mesh);
  return writeGlb(model, path);
}

}  // namespace proveout

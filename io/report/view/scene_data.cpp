#include "io/report/view/scene_data.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"

namespace proveout {

namespace {

using ViewJson = nlohmann::ordered_json;

constexpr double kSteps = 65535.0;

/// Whole numbers of variable length.
class NumberWriter {
 public:
  void add(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes_ += static_cast<char>((value & 127) | 128);
    bytes_ += static_cast<char>(value);
  }
  void addSigned(std::int64_t value) {
    add(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
  }
  void addText(const std::string& text) {
    add(text.size());
    bytes_ += text;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Puts places on the grid of a box, and writes the steps between them.
class PlaceWriter {
 public:
  PlaceWriter(const Box3& box, NumberWriter& out) : box_(box), out_(out) {}
  void add(const Vec3& p) {
    for (int k = 0; k < 3; ++k) {
      const double side = box_.max[k] - box_.min[k];
      const double share = side > 0.0 ? std::clamp((p[k] - box_.min[k]) / side, 0.0, 1.0) : 0.0;
      const auto at = static_cast<std::int64_t>(std::lround(kSteps * share));
      out_.addSigned(at - last_[static_cast<std::size_t>(k)]);
      last_[static_cast<std::size_t>(k)] = at;
    }
  }

 private:
  Box3 box_;
  NumberWriter& out_;
  std::array<std::int64_t, 3> last_{};
};

/// The vertices in the order in which the triangles come to them. Those that none comes to are left out.
struct VertexOrder {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> vertices;   ///< old index by new
  std::vector<std::uint32_t> new_index;  ///< new index by old

  explicit VertexOrder(const TriMesh& mesh) : new_index(mesh.positions.size(), kNone) {
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t v : triangle) {
        if (new_index[v] != kNone) continue;
        new_index[v] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(v);
      }
    }
  }
};

double largestDeviation(const ViewMesh& view) {
  double largest = 0.0;
  for (const float value : view.deviation_mm) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(static_cast<double>(value)));
  }
  return largest;
}

/// What a step of the written deviations is, mm.
double deviationUnit(const ViewMesh& view) {
  return view.deviation_mm.empty() ? 0.0 : std::max(1e-6, largestDeviation(view) / 32767.0);
}

/// Their head says how many vertices and triangles follow.
ViewJson meshHead(const ViewMesh& view) {
  return {{"vertices", VertexOrder(view.mesh).vertices.size()},
          {"triangles", view.mesh.triangles.size()},
          {"of", view.made_of},
          {"off", view.off_mm},
          {"unit", deviationUnit(view)}};
}

void writeDeviations(const ViewMesh& view, const VertexOrder& order, NumberWriter& out) {
  const double unit = deviationUnit(view);
  std::int64_t last = 0;
  for (const std::uint32_t v : order.vertices) {
    const double value = static_cast<double>(view.deviation_mm[v]);
    if (!std::isfinite(value)) {
      out.add(0);
      continue;
    }
    const auto at = static_cast<std::int64_t>(std::lround(value / unit)), step = at - last;
    // 1, 3, 5: forwards by 0, 1, 2; 2, 4: backwards by 1, 2.
    out.add(step >= 0 ? 2 * static_cast<std::uint64_t>(step) + 1 : 2 * static_cast<std::uint64_t>(-step));
    last = at;
  }
}

void writeViewMesh(const ViewMesh& view, const Box3& box, NumberWriter& out) {
  PROVEOUT_ASSERT(view.deviation_mm.empty() || view.deviation_mm.size() == view.mesh.positions.size());
  const VertexOrder order(view.mesh);
  PlaceWriter places(box, out);
  for (const std::uint32_t v : order.vertices) places.add(view.mesh.positions[v].cast<double>());
  std::uint32_t next = 0;
  for (const auto& triangle : view.mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      const std::uint32_t index = order.new_index[v];
      out.add(next - index);
      if (index == next) ++next;
    }
  }
  if (!view.deviation_mm.empty()) writeDeviations(view, order, out);
}

ViewJson placeJson(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
ViewJson boxJson(const Box3& box) { return {{"min", placeJson(box.min)}, {"max", placeJson(box.max)}}; }

Box3 boundsOf(const ViewPath& path) {
  Box3 box;
  for (const ViewPath::Point& point : path.points) box.extend(point.at);
  return box;
}

ViewJson pathHead(const ViewPath& path) {
  ViewJson tools = ViewJson::array();
  for (const ViewPath::Tool& tool : path.tools) {
    ViewJson outline = ViewJson::array();
    for (const Vec2& p : tool.outline) outline.push_back({p.x(), p.y()});
    tools.push_back({{"name", tool.name}, {"outline", outline}});
  }
  return {{"blocks", path.blocks.size()}, {"points", path.points.size()}, {"box", boxJson(boundsOf(path))},
          {"turns", !path.axes.empty()},  {"off", path.off_mm},           {"setups", path.setups},
          {"files", path.files},          {"texts", path.texts},          {"tools", tools}};
}

void writeBlocks(const ViewPath& path, NumberWriter& out) {
  std::array<std::int64_t, 5> last{};
  for (std::size_t i = 0; i < path.blocks.size(); ++i) {
    const ViewPath::Block& block = path.blocks[i];
    const std::array<std::int64_t, 5> row{block.setup, block.file, block.line, block.n, block.tool};
    for (std::size_t k = 0; k < row.size(); ++k) out.addSigned(row[k] - last[k]);
    last = row;
    out.add((i + 1 < path.blocks.size() ? path.blocks[i + 1].first : path.points.size()) - block.first);
  }
}

void writePath(const ViewPath& path, NumberWriter& out) {
  writeBlocks(path, out);
  PlaceWriter places(boundsOf(path), out);
  for (const ViewPath::Point& point : path.points) places.add(point.at);
  std::int64_t last_ms = 0;
  for (const ViewPath::Point& point : path.points) {
    const std::int64_t ms = std::max(last_ms, std::int64_t{std::llround(1e3 * point.time_s)});
    out.add(static_cast<std::uint64_t>(point.move));
    out.add(static_cast<std::uint64_t>(ms - last_ms));
    last_ms = ms;
  }
  std::array<std::int64_t, 3> last{};
  for (const Vec3& axis : path.axes) {
    for (int k = 0; k < 3; ++k) {
      const std::int64_t at = std::lround(1e3 * axis[k]);
      out.addSigned(at - last[static_cast<std::size_t>(k)]);
      last[static_cast<std::size_t>(k)] = at;
    }
  }
}

std::string hexColour(const std::array<float, 3>& rgb) {
  const auto byte = [](float c) { return static_cast<int>(std::lround(255.0F * std::clamp(c, 0.0F, 1.0F))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(rgb[0]), byte(rgb[1]), byte(rgb[2]));
}

ViewJson scaleJson(const ViewScale& scale) {
  if (scale.stops.empty()) return nullptr;
  ViewJson stops = ViewJson::array();
  for (const ViewScale::Stop& stop : scale.stops) stops.push_back({stop.value_mm, hexColour(stop.rgb)});
  return {{"stops", stops}, {"ticks", scale.ticks_mm}};
}

ViewJson findingsJson(const std::vector<ViewFinding>& findings) {
  ViewJson all = ViewJson::array();
  for (const ViewFinding& f : findings) {
    all.push_back({{"n", f.number},
                   {"kind", f.kind},
                   {"severity", severityName(f.severity)},
                   {"at", placeJson(f.at)},
                   {"size", f.size_mm},
                   {"block", f.block}});
  }
  return all;
}

std::string deflated(const std::string& bytes) {
  constexpr int kLevel = 6;  // 9 takes four times as long for a hundredth
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int code =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), kLevel);
  PROVEOUT_ASSERT(code == Z_OK);  // the room is as much as zlib can ask for
  out.resize(size);
  return out;
}

}  // namespace

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0U;
    };
    const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
    out += kDigits[group >> 18];
    out += kDigits[group >> 12 & 63];
    out += i + 1 < bytes.size() ? kDigits[group >> 6 & 63] : '=';
    out += i + 2 < bytes.size() ? kDigits[group & 63] : '=';
  }
  return out;
}

std::string encodeView(const ViewScene& scene) {
  PROVEOUT_ASSERT(!scene.part.mesh.triangles.empty() && scene.scale.stops.size() <= kMostViewStops);
  Box3 box = meshBounds(scene.part.mesh);
  if (scene.nominal) box.extend(meshBounds(scene.nominal->mesh));
  const ViewJson head{{"box", boxJson(box)},
                      {"part", meshHead(scene.part)},
                      {"nominal", scene.nominal ? meshHead(*scene.nominal) : ViewJson(nullptr)},
                      {"scale", scaleJson(scene.scale)},
                      {"findings", findingsJson(scene.findings)},
                      {"path", scene.path ? pathHead(*scene.path) : ViewJson(nullptr)}};
  NumberWriter out;
  out.addText(head.dump(-1, ' ', false, ViewJson::error_handler_t::replace));
  writeViewMesh(scene.part, box, out);
  if (scene.nominal) writeViewMesh(*scene.nominal, box, out);
  if (scene.path) writePath(*scene.path, out);
  return base64(deflated(out.bytes()));
}

}  // namespace proveout

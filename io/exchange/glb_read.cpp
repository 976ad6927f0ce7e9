// Reads GLB files as meshes. Our own, since a nominal decides a verdict: the Open Asset Import Library (5.2.5)
// takes coordinates that are not finite, and drops triangles whose corners are out of range without a word
// (docs/decisions/003-own-mesh-files.md).
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "core/base/memory_limit.h"
#include "core/base/printable.h"
#include "io/mesh_formats.h"

namespace proveout::mesh_formats {
namespace {

using GlbTree = nlohmann::json;

/// What is wrong with a file; caught in readGlb.
struct GlbFault {
  std::string text;
};
template <typename... Args>
[[noreturn]] void glbFault(fmt::format_string<Args...> text, Args&&... args) {
  throw GlbFault{fmt::format(text, std::forward<Args>(args)...)};
}

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return word;
}

/// JSON and binary part.
struct GlbChunks {
  std::string_view json, binary;
};

GlbChunks splitGlb(std::string_view bytes) {
  constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;
  if (bytes.size() < 20 || wordAt(bytes, 0) != kMagic)
    glbFault("is no GLB file: it does not begin with glTF");
  if (wordAt(bytes, 4) != 2) glbFault("is glTF {}; version 2 can be read", wordAt(bytes, 4));
  if (wordAt(bytes, 8) != bytes.size())
    glbFault("holds {} bytes where its header says {}: cut short, or damaged", bytes.size(),
             wordAt(bytes, 8));
  GlbChunks out;
  std::size_t at = 12;
  for (int number = 0; at < bytes.size(); ++number) {
    if (bytes.size() - at < 8 || wordAt(bytes, at) > bytes.size() - at - 8)
      glbFault("has a chunk that is cut short at byte {}", at);
    const std::string_view content = bytes.substr(at + 8, wordAt(bytes, at));
    const std::uint32_t kind = wordAt(bytes, at + 4);
    if ((number == 0) != (kind == kJson)) glbFault("does not have its JSON part first, and once");
    if (number == 0) out.json = content;
    if (number == 1 && kind == kBinary) out.binary = content;
    at += 8 + content.size();
  }
  return out;
}

/// Affine map in double precision.
struct GlbPose {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
  GlbPose operator*(const GlbPose& inner) const {
    return {linear * inner.linear, linear * inner.shift + shift};
  }
};

class GlbFile {
 public:
  GlbFile(const GlbChunks& chunks, MeshBuilder& out) : binary_(chunks.binary), out_(out) {
    tree_ = GlbTree::parse(chunks.json, nullptr, false);
    if (tree_.is_discarded() || !tree_.is_object()) glbFault("has a JSON part that cannot be read");
  }

  void read() {
    checkExtensions();
    const std::vector<Placed> placed = placedMeshes();
    const double triangles = countTriangles(placed);
    constexpr double kBytes = 50.0;  // of a triangle with its share of the corners
    if (const Status fits = memoryFor(kBytes * triangles, "the mesh"); !fits)
      throw GlbFault{fits.error().message};
    constexpr double kMost = 2.5e8;
    if (triangles > kMost)
      glbFault("has {:.3g} triangles, with all copies; at most {:g} can be read", triangles, kMost);
    for (const Placed& p : placed) addMesh(p);
  }

 private:
  struct Placed {
    std::size_t mesh;
    GlbPose pose;
  };
  struct Accessor {
    std::size_t offset = 0, stride = 0, count = 0;
    int number = 0;
  };

  /// A member that must be an array; empty where it is not there.
  static const GlbTree& listOf(const GlbTree& tree, const char* key) {
    static const GlbTree kNone = GlbTree::array();
    const auto found = tree.find(key);
    if (found == tree.end()) return kNone;
    if (!found->is_array()) glbFault("'{}' must be a list", key);
    return *found;
  }
  static std::uint64_t wholeOf(const GlbTree& value, const char* what) {
    if (!value.is_number_unsigned()) glbFault("'{}' must be a whole number of 0 or more", what);
    return value.get<std::uint64_t>();
  }
  static std::uint64_t wholeIn(const GlbTree& tree, const char* key, std::uint64_t other) {
    const auto found = tree.find(key);
    return found == tree.end() ? other : wholeOf(*found, key);
  }
  const GlbTree& item(const char* list, std::uint64_t index) const {
    const GlbTree& all = listOf(tree_, list);
    if (index >= all.size() || !all[index].is_object())
      glbFault("there is no {} {}; the file names it", list, index);
    return all[index];
  }

  /// Extensions that the file cannot be understood without.
  void checkExtensions() const {
    for (const GlbTree& name : listOf(tree_, "extensionsRequired")) {
      const std::string text = name.is_string() ? name.get<std::string>() : std::string("?");
      const bool looks = text.starts_with("KHR_materials_") || text.starts_with("KHR_texture_") ||
                         text.starts_with("KHR_lights_") || text.starts_with("EXT_texture_");
      if (!looks)
        glbFault("needs the extension '{}', which is not known: write it without compression",
                 shortened(printable(text)));
    }
  }

  std::vector<std::uint64_t> rootNodes() const {
    const GlbTree& scenes = listOf(tree_, "scenes");
    if (scenes.empty()) glbFault("has no scene");
    std::vector<std::uint64_t> roots;
    for (const GlbTree& node : listOf(item("scenes", wholeIn(tree_, "scene", 0)), "nodes"))
      roots.push_back(wholeOf(node, "nodes"));
    return roots;
  }

  static double numberIn(const GlbTree& value, const char* what) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) glbFault("'{}' must hold numbers", what);
    return value.get<double>();
  }
  static std::vector<double> numbersIn(const GlbTree& node, const char* key, std::size_t count) {
    const GlbTree& list = listOf(node, key);
    if (list.empty()) return {};
    if (list.size() != count) glbFault("'{}' must hold {} numbers", key, count);
    std::vector<double> out;
    for (const GlbTree& value : list) out.push_back(numberIn(value, key));
    return out;
  }

  static GlbPose poseOf(const GlbTree& node) {
    GlbPose pose;
    if (const std::vector<double> m = numbersIn(node, "matrix", 16); !m.empty()) {
      for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row)
          pose.linear(row, column) = m[static_cast<std::size_t>(4 * column + row)];
      }
      pose.shift = {m[12], m[13], m[14]};
      if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
        glbFault("has a node whose matrix is no shift, turn or scale");
      return pose;
    }
    if (const auto q = numbersIn(node, "rotation", 4); !q.empty()) {
      const Eigen::Quaterniond turn(q[3], q[0], q[1], q[2]);
      if (!(std::abs(turn.norm() - 1.0) < 1e-3)) glbFault("has a node whose rotation is no unit quaternion");
      pose.linear = turn.normalized().toRotationMatrix();
    }
    if (const auto s = numbersIn(node, "scale", 3); !s.empty())
      pose.linear = pose.linear * Vec3(s[0], s[1], s[2]).asDiagonal();
    if (const auto t = numbersIn(node, "translation", 3); !t.empty()) pose.shift = {t[0], t[1], t[2]};
    return pose;
  }

  /// The meshes of the scene. Metres with +Y up become mm with +Z up.
  std::vector<Placed> placedMeshes() const {
    struct Visit {
      std::uint64_t node;
      GlbPose parent;
    };
    GlbPose upright;
    upright.linear << 1000, 0, 0, 0, 0, -1000, 0, 1000, 0;
    std::vector<Visit> open;
    const std::vector<std::uint64_t> roots = rootNodes();
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, upright});
    std::vector<Placed> out;
    std::set<std::uint64_t> seen;
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      if (!seen.insert(visit.node).second)
        glbFault("has a node that stands below two others, or below itself");
      const GlbTree& node = item("nodes", visit.node);
      const GlbPose pose = visit.parent * poseOf(node);
      if (node.contains("skin")) glbFault("has a mesh that bones deform, which is no fixed shape");
      if (node.contains("mesh"))
        out.push_back({static_cast<std::size_t>(wholeOf(node["mesh"], "mesh")), pose});
      const GlbTree& children = listOf(node, "children");
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        open.push_back({wholeOf(*child, "children"), pose});
    }
    if (out.empty()) glbFault("has no mesh in its scene");
    return out;
  }

  static int bytesOf(int number) { return number == 5121 ? 1 : number == 5123 ? 2 : 4; }

  Accessor accessor(std::uint64_t index, bool corners) const {
    const GlbTree& a = item("accessors", index);
    Accessor out;
    out.number = static_cast<int>(wholeIn(a, "componentType", 0));
    const bool fits =
        corners ? out.number == 5121 || out.number == 5123 || out.number == 5125 : out.number == 5126;
    const auto type = a.find("type");
    if (!fits || type == a.end() || *type != (corners ? "SCALAR" : "VEC3"))
      glbFault("has {} of a kind that glTF 2.0 does not know", corners ? "indices" : "positions");
    if (a.contains("sparse") || !a.contains("bufferView"))
      glbFault("has {} that are stored as changes (sparse), which is not known",
               corners ? "indices" : "positions");
    const GlbTree& view = item("bufferViews", wholeOf(a["bufferView"], "bufferView"));
    const GlbTree& buffer = item("buffers", wholeIn(view, "buffer", 0));
    if (buffer.contains("uri") || wholeIn(view, "buffer", 0) != 0)
      glbFault("keeps its numbers in another file; write it as one .glb");
    const std::uint64_t item_bytes = static_cast<std::uint64_t>(bytesOf(out.number)) * (corners ? 1 : 3);
    const std::uint64_t start = wholeIn(view, "byteOffset", 0), length = wholeIn(view, "byteLength", 0);
    const std::uint64_t inside = wholeIn(a, "byteOffset", 0), count = wholeIn(a, "count", 0);
    const std::uint64_t stride = wholeIn(view, "byteStride", item_bytes);
    const std::uint64_t size = binary_.size();
    const bool whole = start <= size && length <= size - start && inside <= length && stride >= item_bytes &&
                       stride <= 252 &&
                       (count == 0 || (item_bytes <= length - inside &&
                                       count - 1 <= (length - inside - item_bytes) / stride));
    if (!whole) glbFault("has an accessor ({}) that reaches beyond its data: cut short, or damaged", index);
    out.offset = static_cast<std::size_t>(start + inside);
    out.stride = static_cast<std::size_t>(stride);
    out.count = static_cast<std::size_t>(count);
    return out;
  }

  struct Primitive {
    Accessor positions;
    std::optional<Accessor> corners;
    std::size_t cornerCount() const { return corners ? corners->count : positions.count; }
  };

  std::vector<Primitive> primitivesOf(std::size_t mesh) const {
    std::vector<Primitive> out;
    for (const GlbTree& p : listOf(item("meshes", mesh), "primitives")) {
      if (!p.is_object()) glbFault("has a primitive that is no object");
      const std::uint64_t mode = wholeIn(p, "mode", 4);
      if (mode < 4) glbFault("has points or lines in place of triangles");
      if (mode > 4) glbFault("has strips or fans of triangles, which cannot be read; write plain triangles");
      if (p.contains("targets"))
        glbFault("has a mesh that is deformed (morph targets), which is no fixed shape");
      const auto attributes = p.find("attributes");
      if (attributes == p.end() || !attributes->is_object() || !attributes->contains("POSITION"))
        glbFault("has triangles without positions");
      Primitive primitive;
      primitive.positions = accessor(wholeOf((*attributes)["POSITION"], "POSITION"), false);
      if (p.contains("indices")) primitive.corners = accessor(wholeOf(p["indices"], "indices"), true);
      if (primitive.cornerCount() % 3 != 0) glbFault("has a last triangle that is not whole");
      out.push_back(primitive);
    }
    return out;
  }

  double countTriangles(const std::vector<Placed>& placed) const {
    std::map<std::size_t, double> of_mesh;
    double sum = 0.0;
    for (const Placed& p : placed) {
      const auto [place, is_new] = of_mesh.try_emplace(p.mesh, 0.0);
      if (is_new) {
        for (const Primitive& primitive : primitivesOf(p.mesh)) {
          place->second += static_cast<double>(primitive.cornerCount()) / 3.0;
          place->second += static_cast<double>(primitive.positions.count) / 2.0;
        }
      }
      sum += place->second;
    }
    return sum;
  }

  float floatAt(std::size_t at) const { return std::bit_cast<float>(wordAt(binary_, at)); }
  std::uint32_t cornerAt(const Accessor& a, std::size_t i) const {
    const std::size_t at = a.offset + i * a.stride;
    std::uint32_t value = 0;
    for (int k = bytesOf(a.number); k-- > 0;)
      value = value << 8 | static_cast<unsigned char>(binary_[at + static_cast<std::size_t>(k)]);
    return value;
  }

  void addMesh(const Placed& placed) {
    const bool mirrored = placed.pose.linear.determinant() < 0.0;
    for (const Primitive& primitive : primitivesOf(placed.mesh)) {
      const std::size_t base = out_.mesh.positions.size(), count = primitive.positions.count;
      if (base + count > 0x7FFFFFFF) glbFault("has more positions than can be counted");
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = primitive.positions.offset + i * primitive.positions.stride;
        const Vec3 p =
            placed.pose.linear * Vec3(floatAt(at), floatAt(at + 4), floatAt(at + 8)) + placed.pose.shift;
        if (!out_.addPosition(p.x(), p.y(), p.z())) glbFault("has a coordinate that is not finite");
      }
      for (std::size_t i = 0; i < primitive.cornerCount(); i += 3) {
        std::array<std::uint32_t, 3> t;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t corner = primitive.corners ? cornerAt(*primitive.corners, i + k) : i + k;
          if (corner >= count) glbFault("has a triangle with an index out of range: {}", corner);
          t[k] = static_cast<std::uint32_t>(base + corner);
        }
        if (mirrored) std::swap(t[1], t[2]);
        out_.mesh.triangles.push_back(t);
      }
    }
  }

  std::string_view binary_;
  MeshBuilder& out_;
  GlbTree tree_;
};

}  // namespace

Status readGlb(std::string_view bytes, MeshBuilder& out) {
  try {
    GlbFile(splitGlb(bytes), out).read();
  } catch (const GlbFault& fault) {
    return inputError(fault.text);
  }
  return Done{};
}

}  // namespace proveout::mesh_formats

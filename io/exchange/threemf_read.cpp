// Reads the parts of a 3MF package as one mesh. Our own over minizip and Expat, since a nominal decides a
// verdict: the Open Asset Import Library (5.2.5) does not look at the unit of a 3MF, takes coordinates that are
// no numbers as 0, and gives an empty scene, no error, of a model that is cut short
// (docs/decisions/003-own-mesh-files.md).
#include <expat.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "core/base/memory_limit.h"
#include "core/base/printable.h"
#include "io/exchange/zip_archive.h"
#include "io/mesh_formats.h"

namespace proveout::mesh_formats {
namespace {

constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kRelations = "http://schemas.openxmlformats.org/package/2006/relationships";
constexpr std::string_view kModelRelation = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
/// Extensions that say nothing of the shape of what lies in this one model.
constexpr std::string_view kHarmless[] = {
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/production/alternatives/2021/04"};

/// Attributes of an element by name; those of other namespaces are "NAMESPACE|NAME".
class Attributes {
 public:
  explicit Attributes(const char** pairs) : pairs_(pairs) {}
  const char* find(std::string_view name) const {
    for (const char** pair = pairs_; *pair != nullptr; pair += 2) {
      if (name == pair[0]) return pair[1];
    }
    return nullptr;
  }
  /// By the name alone, in any namespace but none.
  const char* findForeign(std::string_view name) const {
    for (const char** pair = pairs_; *pair != nullptr; pair += 2) {
      const std::string_view key = pair[0];
      const std::size_t bar = key.rfind('|');
      if (bar != std::string_view::npos && key.substr(bar + 1) == name) return pair[1];
    }
    return nullptr;
  }

 private:
  const char** pairs_;
};

/// A document that is read piece by piece. What an element means is the derived class's; `fault` stops it.
class XmlReader {
 public:
  XmlReader() : parser_(XML_ParserCreateNS("UTF-8", '|')) {
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(
        parser_,
        [](void* self, const char* name, const char** pairs) {
          static_cast<XmlReader*>(self)->open(name, pairs);
        },
        [](void* self, const char* name) { static_cast<XmlReader*>(self)->close(name); });
    XML_SetStartDoctypeDeclHandler(parser_, [](void* self, const char*, const char*, const char*, int) {
      static_cast<XmlReader*>(self)->fail("a document type, which 3MF does not allow");
    });
    XML_SetStartNamespaceDeclHandler(parser_, [](void* self, const char* prefix, const char* space) {
      if (prefix != nullptr && space != nullptr) static_cast<XmlReader*>(self)->prefixes[prefix] = space;
    });
  }
  XmlReader(const XmlReader&) = delete;
  virtual ~XmlReader() { XML_ParserFree(parser_); }

  Status parse(std::string_view piece, bool last) {
    const XML_Status status = XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()), last ? 1 : 0);
    if (!fault_.empty()) return inputError(fault_);
    if (status == XML_STATUS_ERROR) {
      return inputError(fmt::format("line {} of its model: {}", XML_GetCurrentLineNumber(parser_),
                                    XML_ErrorString(XML_GetErrorCode(parser_))));
    }
    return Done{};
  }

 protected:
  virtual void element(std::string_view name, const Attributes& attributes) = 0;
  virtual void end(std::string_view) {}
  /// Of the first fault only; stops the parser.
  void fail(const std::string& what) {
    if (!fault_.empty()) return;
    fault_ = fmt::format("line {} of its model: {}", XML_GetCurrentLineNumber(parser_), what);
    XML_StopParser(parser_, XML_FALSE);
  }
  std::map<std::string, std::string> prefixes;

 private:
  void open(const char* name, const char** pairs) {
    if (fault_.empty()) element(name, Attributes(pairs));
  }
  void close(const char* name) {
    if (fault_.empty()) end(name);
  }
  XML_Parser parser_;
  std::string fault_;
};

/// Finds the model of the package.
class RelationReader final : public XmlReader {
 public:
  std::string target;

 private:
  void element(std::string_view name, const Attributes& attributes) override {
    if (name != fmt::format("{}|Relationship", kRelations)) return;
    const char* type = attributes.find("Type");
    const char* to = attributes.find("Target");
    if (type != nullptr && to != nullptr && type == kModelRelation && target.empty()) target = to;
  }
};

/// The matrix of a 3MF: points are rows in front of it.
struct Transform {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
  /// First `inner`, then this.
  Transform operator*(const Transform& inner) const {
    return {linear * inner.linear, linear * inner.shift + shift};
  }
};

struct PlacedObject {
  std::uint32_t object = 0;
  Transform transform;
};

struct ModelObject {
  bool is_model = true;  ///< none of what only helps printing
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<PlacedObject> components;
};

class ModelReader final : public XmlReader {
 public:
  double unit_mm = 1.0;
  std::map<std::uint32_t, ModelObject> objects;
  std::vector<PlacedObject> build;

 private:
  void element(std::string_view name, const Attributes& attributes) override {
    if (!name.starts_with(kCore) || name.size() <= kCore.size() + 1) return;
    const std::string_view tag = name.substr(kCore.size() + 1);
    if (tag == "vertex") return vertex(attributes);
    if (tag == "triangle") return triangle(attributes);
    if (tag == "model") return model(attributes);
    if (tag == "object") return object(attributes);
    if (tag == "component") return component(attributes);
    if (tag == "item") return item(attributes);
  }

  void model(const Attributes& attributes) {
    static const std::map<std::string_view, double> kUnits = {{"micron", 1e-3},     {"millimeter", 1.0},
                                                              {"centimeter", 10.0}, {"inch", 25.4},
                                                              {"foot", 304.8},      {"meter", 1000.0}};
    if (const char* unit = attributes.find("unit")) {
      const auto found = kUnits.find(unit);
      if (found == kUnits.end()) return fail(fmt::format("an unknown unit '{}'", shortened(printable(unit))));
      unit_mm = found->second;
    }
    const char* required = attributes.find("requiredextensions");
    std::string_view rest = required != nullptr ? required : "";
    while (!rest.empty()) {
      const std::size_t end = rest.find(' ');
      const std::string prefix(rest.substr(0, end));
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
      if (prefix.empty()) continue;
      const auto space = prefixes.find(prefix);
      const bool known = space != prefixes.end() && std::find(std::begin(kHarmless), std::end(kHarmless),
                                                              space->second) != std::end(kHarmless);
      if (!known)
        return fail(fmt::format("it needs the extension '{}', which is not known",
                                shortened(printable(space != prefixes.end() ? space->second : prefix))));
    }
  }

  void object(const Attributes& attributes) {
    const auto id = whole(attributes, "id");
    if (!id) return;
    if (objects.contains(*id)) return fail(fmt::format("object {} is there twice", *id));
    current_ = &objects[*id];
    const char* type = attributes.find("type");
    current_->is_model = type == nullptr || std::string_view(type) == "model";
  }

  void vertex(const Attributes& attributes) {
    if (current_ == nullptr) return fail("a vertex outside of an object");
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      constexpr const char* kNames[] = {"x", "y", "z"};
      const char* text = attributes.find(kNames[axis]);
      const std::optional<double> value = parseReal(text != nullptr ? text : "");
      if (!value) return fail(fmt::format("a vertex whose {} is no number", kNames[axis]));
      p[axis] = *value;
    }
    current_->vertices.push_back(p);
  }

  void triangle(const Attributes& attributes) {
    if (current_ == nullptr) return fail("a triangle outside of an object");
    std::array<std::uint32_t, 3> t;
    constexpr const char* kNames[] = {"v1", "v2", "v3"};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = whole(attributes, kNames[k]);
      if (!corner) return;
      if (*corner >= current_->vertices.size())
        return fail(fmt::format("a triangle with an index out of range: {}", *corner));
      t[k] = *corner;
    }
    current_->triangles.push_back(t);
  }

  void component(const Attributes& attributes) {
    if (current_ == nullptr) return fail("a component outside of an object");
    if (const auto placed = placedObject(attributes)) current_->components.push_back(*placed);
  }

  void item(const Attributes& attributes) {
    if (const auto placed = placedObject(attributes)) build.push_back(*placed);
  }

  std::optional<PlacedObject> placedObject(const Attributes& attributes) {
    if (attributes.findForeign("path") != nullptr) {
      fail("an object in another model of the package, which is not read; save it without splitting");
      return std::nullopt;
    }
    const auto id = whole(attributes, "objectid");
    if (!id) return std::nullopt;
    PlacedObject out{*id, {}};
    const char* text = attributes.find("transform");
    if (text == nullptr) return out;
    TextScanner scanner(text);
    std::array<double, 12> m;
    for (double& value : m) {
      const std::optional<double> number = parseReal(scanner.word());
      if (!number || !std::isfinite(*number)) {
        fail("a transform that does not hold 12 numbers");
        return std::nullopt;
      }
      value = *number;
    }
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        out.transform.linear(column, row) = m[static_cast<std::size_t>(3 * row + column)];
    }
    out.transform.shift = {m[9], m[10], m[11]};
    return out;
  }

  std::optional<std::uint32_t> whole(const Attributes& attributes, const char* name) {
    const char* text = attributes.find(name);
    const std::string_view digits = text != nullptr ? text : "";
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc{} && end == digits.data() + digits.size()) return value;
    fail(fmt::format("'{}' is no whole number of 0 or more", name));
    return std::nullopt;
  }

  void end(std::string_view name) override {
    if (name == fmt::format("{}|object", kCore)) current_ = nullptr;
  }

  ModelObject* current_ = nullptr;
};

/// Puts what the model builds into one mesh.
class Assembler {
 public:
  Assembler(const ModelReader& model, MeshBuilder& out) : model_(model), out_(out) {}

  Status assemble() {
    double count = 0.0;
    for (const PlacedObject& item : model_.build) {
      const Result<double> size = sizeOf(item.object, 0);
      if (!size) return size.error();
      count += *size;
    }
    constexpr double kBytes = 50.0, kMost = 2.5e8;
    if (const Status fits = memoryFor(kBytes * count, "the mesh"); !fits) return fits;
    if (count > kMost)
      return inputError(
          fmt::format("has {:.3g} triangles, with all copies; at most {:g} can be read", count, kMost));
    Transform unit;
    unit.linear *= model_.unit_mm;
    for (const PlacedObject& item : model_.build) {
      if (const Status done = add(item, unit); !done) return done;
    }
    return Done{};
  }

 private:
  static constexpr int kDeepest = 64;

  /// Triangles and half the vertices of an object with all its components.
  Result<double> sizeOf(std::uint32_t id, int depth) {
    if (const auto known = sizes_.find(id); known != sizes_.end()) return known->second;
    const auto found = model_.objects.find(id);
    if (found == model_.objects.end()) return inputError(fmt::format("has no object {}, which it names", id));
    if (depth > kDeepest) return inputError("has objects that are made of each other without an end");
    double size = static_cast<double>(found->second.triangles.size()) +
                  0.5 * static_cast<double>(found->second.vertices.size());
    for (const PlacedObject& part : found->second.components) {
      const Result<double> more = sizeOf(part.object, depth + 1);
      if (!more) return more;
      size += *more;
    }
    // An object without a triangle still takes a step each time that it is placed.
    return sizes_[id] = size + 1.0;
  }

  Status add(const PlacedObject& placed, const Transform& outer) {
    const ModelObject& object = model_.objects.at(placed.object);
    if (!object.is_model) return Done{};
    const Transform to = outer * placed.transform;
    for (const PlacedObject& part : object.components) {
      if (const Status done = add(part, to); !done) return done;
    }
    const std::size_t base = out_.mesh.positions.size();
    if (base + object.vertices.size() > 0x7FFFFFFF)
      return inputError("has more vertices than can be counted");
    for (const Vec3& vertex : object.vertices) {
      const Vec3 p = to.linear * vertex + to.shift;
      if (!out_.addPosition(p.x(), p.y(), p.z())) return inputError("has a coordinate that is not finite");
    }
    const bool mirrored = to.linear.determinant() < 0.0;
    for (std::array<std::uint32_t, 3> t : object.triangles) {
      if (mirrored) std::swap(t[1], t[2]);
      for (std::uint32_t& corner : t) corner += static_cast<std::uint32_t>(base);
      out_.mesh.triangles.push_back(t);
    }
    return Done{};
  }

  const ModelReader& model_;
  MeshBuilder& out_;
  std::map<std::uint32_t, double> sizes_;
};

Status parsePart(ZipReader& zip, const std::string& name, XmlReader& reader) {
  if (const Status done = zip.read(name, [&](std::string_view piece) { return reader.parse(piece, false); });
      !done)
    return done;
  return reader.parse({}, true);
}

}  // namespace

Status readThreeMf(std::string_view bytes, MeshBuilder& out) {
  Result<ZipReader> zip = ZipReader::open(bytes);
  if (!zip) return zip.error();
  RelationReader relations;
  if (const Status done = parsePart(*zip, "_rels/.rels", relations); !done) return done;
  if (relations.target.empty()) return inputError("is no 3MF package: it names no 3D model");
  const std::string name = relations.target.substr(relations.target.starts_with('/') ? 1 : 0);
  // A vertex or triangle takes no more room than its text.
  const double size = static_cast<double>(std::max<std::int64_t>(0, zip->sizeOf(name)));
  if (const Status fits = memoryFor(size, "the model"); !fits) return fits;
  ModelReader model;
  if (const Status done = parsePart(*zip, name, model); !done) return done;
  if (model.build.empty()) return inputError("builds nothing: it has no item");
  return Assembler(model, out).assemble();
}

}  // namespace proveout::mesh_formats

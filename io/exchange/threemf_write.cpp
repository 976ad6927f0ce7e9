// The writer is our own since the bytes must depend on the mesh alone and keep its coordinates: lib3mf
// (1.8.1) cuts them to six decimals and gives every object a random UUID
// (docs/decisions/003-own-mesh-files.md).
#include <fmt/format.h>

#include <charconv>

#include "io/exchange/hashed_file.h"
#include "io/exchange/threemf.h"
#include "io/exchange/zip_archive.h"

namespace proveout {
namespace {

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
 <Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
 <Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr std::string_view kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
 <Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";
constexpr std::string_view kModelHead =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
 <metadata name="Application">proveout</metadata>
 <resources>)";

/// Longest line of a vertex or a triangle, bytes: beyond 4 GB of text the archive needs wider fields.
constexpr double kLongestVertex = 80.0, kLongestTriangle = 64.0;
constexpr double kNarrowZip = 4.0e9;

void addNumber(std::string& out, std::string_view before, float value) {
  out += before;
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  out.append(digits, static_cast<std::size_t>(end - digits));
}

void addIndex(std::string& out, std::string_view before, std::uint32_t value) {
  out += before;
  char digits[16];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  out.append(digits, static_cast<std::size_t>(end - digits));
}

/// Gives text to the archive in pieces.
class ModelText {
 public:
  explicit ModelText(ZipWriter& zip) : zip_(zip) {}
  std::string text;
  void spill(std::size_t most = std::size_t{1} << 18) {
    if (text.size() < most) return;
    zip_.write(text);
    text.clear();
  }

 private:
  ZipWriter& zip_;
};

void writeObject(const TriMesh& mesh, ModelText& out) {
  out.text += "\n  <object id=\"1\" type=\"model\" name=\"part\"><mesh>\n   <vertices>\n";
  for (const Eigen::Vector3f& p : mesh.positions) {
    addNumber(out.text, "<vertex x=\"", p.x());
    addNumber(out.text, "\" y=\"", p.y());
    addNumber(out.text, "\" z=\"", p.z());
    out.text += "\"/>\n";
    out.spill();
  }
  out.text += "   </vertices>\n   <triangles>\n";
  for (const auto& t : mesh.triangles) {
    addIndex(out.text, "<triangle v1=\"", t[0]);
    addIndex(out.text, "\" v2=\"", t[1]);
    addIndex(out.text, "\" v3=\"", t[2]);
    out.text += "\"/>\n";
    out.spill();
  }
  out.text += "   </triangles>\n  </mesh></object>";
}

}  // namespace

Result<std::string> writeThreeMf(const TriMesh& mesh, const std::string& path) {
  const bool empty = mesh.triangles.empty();
  const double longest = kLongestVertex * static_cast<double>(mesh.positions.size()) +
                         kLongestTriangle * static_cast<double>(mesh.triangles.size());
  ZipWriter zip;
  zip.begin("[Content_Types].xml");
  zip.write(kContentTypes);
  zip.begin("_rels/.rels");
  zip.write(kRelationships);
  zip.begin("3D/3dmodel.model", longest > kNarrowZip);
  ModelText model(zip);
  model.text = kModelHead;
  if (!empty) writeObject(mesh, model);
  model.text += empty ? "</resources>\n <build/>\n</model>\n"
                      : "\n </resources>\n <build>\n  <item objectid=\"1\"/>\n </build>\n</model>\n";
  model.spill(0);
  const Result<std::string> bytes = zip.finish();
  if (!bytes) return Error{bytes.error().kind, path + ": " + bytes.error().message};
  return writeHashed(path, *bytes);
}

}  // namespace proveout

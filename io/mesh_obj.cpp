// Wavefront OBJ: vertices and polygonal faces.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "io/mesh_formats.h"

namespace proveout::mesh_formats {

namespace {

/// Statements that say nothing of the shape of polygons.
constexpr std::array<std::string_view, 17> kNoShape = {
    "vn",     "vt",    "g",        "o",        "s",   "mg",         "usemtl",    "mtllib", "usemap",
    "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "vp"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, MeshBuilder& out) : bytes_(bytes), out_(out) {}

  Status read() {
    while (!bytes_.empty()) {
      const int first_line = line_ + 1;
      const std::string_view text = nextLine();
      const std::string error = readStatement(text);
      if (!error.empty()) return inputError(fmt::format("line {}: {}", first_line, error));
    }
    return Done{};
  }

 private:
  /// The next line, with the lines that a backslash joins to it. The view is good until the next call.
  std::string_view nextLine() {
    joined_.clear();
    while (true) {
      const std::size_t end = bytes_.find('\n');
      std::string_view line = bytes_.substr(0, end);
      bytes_.remove_prefix(end == std::string_view::npos ? bytes_.size() : end + 1);
      ++line_;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      const bool goes_on = !line.empty() && line.back() == '\\' && !bytes_.empty();
      if (!goes_on && joined_.empty()) return line;
      if (goes_on) line.remove_suffix(1);
      joined_.append(line).append(goes_on ? " " : "");
      if (!goes_on) return joined_;
    }
  }

  std::string readStatement(std::string_view text) {
    TextScanner scanner(text.substr(0, text.find('#')));
    const std::string_view word = scanner.wordInLine();
    if (word.empty()) return {};
    if (word == "v") return readVertex(scanner);
    if (word == "f" || word == "fo") return readFace(scanner);
    if (word == "p" || word == "l") return "points and lines are not a surface";
    if (std::find(kNoShape.begin(), kNoShape.end(), word) != kNoShape.end()) return {};
    return fmt::format("statement '{}' is not supported; surfaces must be polygons", word.substr(0, 32));
  }

  std::string readVertex(TextScanner& scanner) {
    std::array<double, 7> numbers{};
    std::size_t count = 0;
    for (auto word = scanner.wordInLine(); !word.empty(); word = scanner.wordInLine()) {
      const auto value = parseReal(word);
      if (!value || count == numbers.size()) return "a vertex is v x y z, with a weight or colour behind it";
      numbers[count++] = *value;
    }
    // x y z, x y z w, x y z r g b, x y z w r g b. The weight is for curves only.
    if (count != 3 && count != 4 && count != 6 && count != 7) return "a vertex needs three coordinates";
    if (out_.mesh.positions.size() >= 0xFFFFFFFEu) return "too many vertices";
    if (!out_.addPosition(numbers[0], numbers[1], numbers[2])) return "a coordinate is not a finite number";
    return {};
  }

  std::string readFace(TextScanner& scanner) {
    corners_.clear();
    for (auto word = scanner.wordInLine(); !word.empty(); word = scanner.wordInLine()) {
      const auto corner = readCorner(word);
      if (!corner) return fmt::format("'{}' is no vertex of this file", word.substr(0, 64));
      corners_.push_back(*corner);
    }
    return out_.addPolygon(corners_);
  }

  /// `7`, `7/2`, `7/2/3`, `7//3`; negative numbers count back from the last vertex.
  std::optional<std::uint32_t> readCorner(std::string_view word) const {
    const std::string_view digits = word.substr(0, word.find('/'));
    if (!restIsValid(word.substr(digits.size()))) return std::nullopt;
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
    const auto count = static_cast<std::int64_t>(out_.mesh.positions.size());
    if (index < 0) index += count + 1;
    if (index < 1 || index > count) return std::nullopt;
    return static_cast<std::uint32_t>(index - 1);
  }

  static bool restIsValid(std::string_view rest) {
    return rest.find_first_not_of("/-0123456789") == std::string_view::npos &&
           std::count(rest.begin(), rest.end(), '/') <= 2;
  }

  std::string_view bytes_;
  MeshBuilder& out_;
  int line_ = 0;
  std::string joined_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

Status readObj(std::string_view bytes, MeshBuilder& out) {
  if (bytes.substr(0, 4096).find('\0') != std::string_view::npos)
    return inputError("is no OBJ file: it is binary");
  return ObjReader(bytes, out).read();
}

}  // namespace proveout::mesh_formats

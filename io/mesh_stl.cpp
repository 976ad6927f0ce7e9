// STL, binary and ASCII.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "io/mesh_formats.h"

#include "core/base/assert.h"

namespace proveout::mesh_formats {

namespace {

constexpr std::size_t kHeader = 84, kRecord = 50;  // bytes: 80 of text and the count; 12 floats and 16 bits

std::uint32_t littleEndian32(const char* p) {
  const auto* b = reinterpret_cast<const unsigned char*>(p);
  return b[0] | std::uint32_t{b[1]} << 8 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[3]} << 24;
}

std::uint32_t binaryCount(std::string_view bytes) { return littleEndian32(bytes.data() + 80); }

bool sizeFitsBinary(std::string_view bytes) {
  return bytes.size() >= kHeader && bytes.size() == kHeader + kRecord * std::uint64_t{binaryCount(bytes)};
}

/// Many binary files begin with "solid", so the word alone says nothing; a zero byte does.
bool looksLikeText(std::string_view bytes) {
  TextScanner scanner(bytes);
  if (lowerCase(scanner.word()) != "solid") return false;
  return bytes.substr(0, 1024).find('\0') == std::string_view::npos;
}

void addTriangle(MeshBuilder& out) {
  const auto n = static_cast<std::uint32_t>(out.mesh.positions.size());
  PROVEOUT_ASSERT(n >= 3);
  out.mesh.triangles.push_back({n - 3, n - 2, n - 1});
}

Status readBinary(std::string_view bytes, MeshBuilder& out) {
  const std::uint32_t count = binaryCount(bytes);
  if (count > 0xFFFFFFFFu / 3) return inputError(fmt::format("has too many triangles ({})", count));
  out.mesh.positions.reserve(std::size_t{3} * count);
  out.mesh.triangles.reserve(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    // The normal comes first and is left aside: the order of the corners says the same.
    const char* corner = bytes.data() + kHeader + kRecord * std::size_t{t} + 12;
    for (int k = 0; k < 3; ++k, corner += 12) {
      const auto coordinate = [&](int i) {
        return static_cast<double>(std::bit_cast<float>(littleEndian32(corner + 4 * i)));
      };
      if (!out.addPosition(coordinate(0), coordinate(1), coordinate(2))) {
        return inputError(fmt::format("triangle {} has a coordinate that is not a finite number", t + 1));
      }
    }
    addTriangle(out);
  }
  return Done{};
}

class AsciiReader {
 public:
  AsciiReader(std::string_view bytes, MeshBuilder& out) : scanner_(bytes), out_(out) {}

  Status read() {
    for (std::string word = next(); !word.empty() && error_.empty(); word = next()) {
      if (word != "solid") {
        fail("'solid' expected, not '" + word + "'");
        break;
      }
      scanner_.skipLine();  // the rest of the line is the name
      readSolid();
    }
    if (!error_.empty()) return inputError(error_);
    return Done{};
  }

 private:
  std::string next() { return lowerCase(scanner_.word()); }

  void fail(const std::string& what) {
    if (!error_.empty()) return;
    error_ = scanner_.atEnd() ? "is cut short: it ends inside a solid"
                              : fmt::format("line {}: {}", scanner_.line(), what);
  }

  bool expect(std::string_view word) {
    const std::string got = next();
    if (got == word) return true;
    fail(fmt::format("'{}' expected, not '{}'", word, got));
    return false;
  }

  void readSolid() {
    while (error_.empty()) {
      const std::string word = next();
      if (word == "endsolid") {
        scanner_.skipLine();
        return;
      }
      if (word != "facet") {
        fail("'facet' or 'endsolid' expected, not '" + word + "'");
        return;
      }
      readFacet();
    }
  }

  void readFacet() {
    if (!expect("normal")) return;
    for (int i = 0; i < 3; ++i) {
      // Only its form is checked: writers put NaN here for slivers, and the order of the corners says it all.
      if (!parseReal(scanner_.word())) return fail("a normal has three numbers");
    }
    if (!expect("outer") || !expect("loop")) return;
    for (int k = 0; k < 3; ++k) {
      if (!expect("vertex") || !readVertex()) return;
    }
    if (!expect("endloop") || !expect("endfacet")) return;
    addTriangle(out_);
  }

  bool readVertex() {
    std::array<double, 3> p{};
    for (double& x : p) {
      const auto value = parseReal(scanner_.word());
      if (!value) {
        fail("a vertex has three numbers");
        return false;
      }
      x = *value;
    }
    if (out_.addPosition(p[0], p[1], p[2])) return true;
    error_ = fmt::format("line {}: a coordinate is not a finite number", scanner_.line());
    return false;
  }

  TextScanner scanner_;
  MeshBuilder& out_;
  std::string error_;
};

}  // namespace

Status readStl(std::string_view bytes, MeshBuilder& out) {
  if (sizeFitsBinary(bytes)) return readBinary(bytes, out);
  if (looksLikeText(bytes)) return AsciiReader(bytes, out).read();
  if (bytes.size() < kHeader) return inputError("is no STL file: too short for a binary one, and no text");
  const std::uint64_t needed = kHeader + kRecord * std::uint64_t{binaryCount(bytes)};
  return inputError(fmt::format(
      "is no STL file, or is {}: its header counts {} triangles, which take {} bytes, and "
      "it has {}",
      bytes.size() < needed ? "cut short" : "too long", binaryCount(bytes), needed, bytes.size()));
}

}  // namespace proveout::mesh_formats

// Readers of mesh files, one a format. Strict: a file that does not follow its format to the last byte is
// refused, since a nominal that was cut short would pass for another part.
//
// They are our own. The Open Asset Import Library (5.2, as in Debian 12) reads these formats too, but takes
// NaN coordinates, lines among the faces, and an ASCII PLY that lacks its last face without a word. The tests
// read our files back with it.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/mesh/tri_mesh.h"

namespace proveout::mesh_formats {

/// Polygons of more corners are refused unless they are convex: cutting ears takes cubic time at worst.
inline constexpr std::size_t kMaxConcaveCorners = 1024;

/// What the readers fill. `scale` turns the file's unit into mm.
struct MeshBuilder {
  TriMesh mesh;
  double scale = 1.0;

  /// Adds a position; false if it is not finite in single precision after scaling.
  bool addPosition(double x, double y, double z);
  /// Cuts a polygon into triangles. Corners are indices of positions, in range. Returns what is wrong, or "".
  std::string addPolygon(std::span<const std::uint32_t> corners);
};

/// Reads blanks, lines and numbers of a text file; keeps the line for messages.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : rest_(text) {}

  int line() const { return line_; }
  /// Next word, over line ends; empty at the end of the text.
  std::string_view word();
  /// Next word of this line; empty at its end.
  std::string_view wordInLine();
  /// Goes to the start of the next line.
  void skipLine();
  bool atEnd() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view takeWord();

  std::string_view rest_;
  int line_ = 1;
};

/// A whole word as a number; infinities and NaN included, as the caller tells them apart.
std::optional<double> parseReal(std::string_view word);

std::string lowerCase(std::string_view text);

/// Each reads the whole file. The error's text has no file name.
Status readStl(std::string_view bytes, MeshBuilder& out);
Status readObj(std::string_view bytes, MeshBuilder& out);
Status readPly(std::string_view bytes, MeshBuilder& out);
/// These two state their unit: `scale` is 1.
Status readGlb(std::string_view bytes, MeshBuilder& out);
Status readThreeMf(std::string_view bytes, MeshBuilder& out);

}  // namespace proveout::mesh_formats

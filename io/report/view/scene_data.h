// What the 3-D view of report.html shows, and how it goes into the page: one line of base64, of deflated
// bytes. They are the length of a JSON head, the head, and whole numbers of variable length (LEB128), which
// io/report/view/decode.js reads in the same order. Equal scenes give equal bytes. Lengths mm, times s, frame
// of the finished part.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/geometry/types.h"
#include "core/mesh/tri_mesh.h"

namespace proveout {

/// A mesh for the eye: places are put on a grid of 65,536 steps along each side of the scene's box.
struct ViewMesh {
  TriMesh mesh;                     ///< its `motion` is not used
  std::vector<float> deviation_mm;  ///< per vertex, NaN where it is not known; empty: none is shown
  double off_mm = 0.0;              ///< how far it may be off the mesh that it was made of
  std::uint64_t made_of = 0;        ///< triangles of that mesh
};

/// Colours of the deviations: linear between the stops, values ascending; two stops of one value are a step.
struct ViewScale {
  struct Stop {
    double value_mm = 0.0;
    std::array<float, 3> rgb{};  ///< sRGB, 0..1
  };
  std::vector<Stop> stops;       ///< at most kMostViewStops; empty: no scale
  std::vector<double> ticks_mm;  ///< numbers of the legend, the more important first
};
inline constexpr std::size_t kMostViewStops = 32;  ///< as io/report/view/surface.js has it

struct ViewFinding {
  std::size_t number = 0;  ///< as in the report, from 1
  std::string kind;
  Severity severity = Severity::kError;
  Vec3 at = Vec3::Zero();
  double size_mm = 0.0;     ///< about how wide what was found is; 0: not known
  std::int64_t block = -1;  ///< index into ViewPath::blocks; -1: none
};

/// How the way to a point is gone; kStart: it is not, a line begins there.
enum class ViewMove : std::uint8_t { kRapid, kFeed, kThread, kProbe, kStart };

/// The tool path as chords.
struct ViewPath {
  struct Tool {
    std::string name;
    std::vector<Vec2> outline;  ///< (r, z) from the tip upwards; empty: it does not turn about its axis
  };
  /// An execution of a block. It has the points from `first` to the next one's.
  struct Block {
    std::uint32_t setup = 0, file = 0, tool = 0;  ///< indices
    std::uint32_t line = 0;
    std::int64_t n = -1;
    std::size_t first = 0;
  };
  struct Point {
    Vec3 at = Vec3::Zero();
    double time_s = 0.0;  ///< since the start of the run; never falls
    ViewMove move = ViewMove::kStart;
  };
  std::vector<std::string> setups, files;
  std::vector<std::vector<std::string>> texts;  ///< lines by file; empty: not carried
  std::vector<Tool> tools;
  std::vector<Block> blocks;  ///< at least one
  std::vector<Point> points;  ///< at least one
  std::vector<Vec3> axes;     ///< of the tool, unit, by point; empty: +z throughout
  double off_mm = 0.0;        ///< points nearer than this to others were left out; 0: none were
};

struct ViewScene {
  ViewMesh part;
  std::optional<ViewMesh> nominal;
  ViewScale scale;
  std::vector<ViewFinding> findings;
  std::optional<ViewPath> path;
};

/// The scene in the form of the page. Requires triangles in the part.
std::string encodeView(const ViewScene& scene);

/// Bytes in base64 (RFC 4648).
std::string base64(std::string_view bytes);

}  // namespace proveout

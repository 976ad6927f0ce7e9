// Short ways to cut a path into a blank in tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "removal/grid/stock.h"

namespace proveout::test {

/// Builds a path with one tool, spindle on.
class PathMaker {
 public:
  explicit PathMaker(int tool = 1) : tool_(tool) { path_.files = {"test"}; }
  PathMaker& line(const Vec3& from, const Vec3& to, MotionKind kind = MotionKind::kFeed) {
    Motion m = motion(from, to, kind);
    path_.motions.push_back(m);
    return *this;
  }
  /// Arc about `normal` through `center` from `from`, by sweep_deg, rising `rise` along the normal.
  PathMaker& arc(const Vec3& from, const Vec3& center, const Vec3& normal, double sweep_deg,
                 double rise = 0.0);
  const Toolpath& path() const { return path_; }
  Toolpath& path() { return path_; }

 private:
  Motion motion(const Vec3& from, const Vec3& to, MotionKind kind) {
    Motion m;
    m.from = from;
    m.to = to;
    m.kind = kind;
    m.tool = tool_;
    m.spindle = 1000;
    m.source.line = static_cast<std::uint32_t>(path_.motions.size() + 1);
    return m;
  }
  int tool_;
  Toolpath path_;
};

struct Cut {
  double initial = 0.0;      ///< mm3
  double volume = 0.0;       ///< mm3, from the exact crossings
  double mesh_volume = 0.0;  ///< mm3, of the facets
  TriMesh mesh;
  std::size_t thin_cells = 0;
  RemovalSummary summary;
};

/// Cuts and extracts; fails the test on any error and unless the mesh is a closed 2-manifold.
Cut cut(const StockShape& shape, const Toolpath& path, const std::vector<Tool>& tools, double resolution,
        int threads = 2);

Tool tool(const std::string& option);  ///< from "1=flat:10"

}  // namespace proveout::test

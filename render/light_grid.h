// Shares of light over a band of a picture: found by few rays, averaged over each surface.
#pragma once

#include <vector>

#include "render/light_points.h"
#include "render/surfaces.h"

namespace proveout::render_detail {

/// Rows of what the pixels see.
struct SeenBand {
  int first = 0, rows = 0, width = 0;
  std::vector<Seen> seen;
  const Seen& at(int x, int y) const { return seen[static_cast<std::size_t>(y - first) * width + x]; }
};

class LightGrid {
 public:
  static constexpr int kStep = 2;          ///< pixels between its points
  static constexpr int kPattern = 7;       ///< points of the grid after which the points of the lights repeat
  static constexpr int kRefinedReach = 1;  ///< of points that ask for more
  static constexpr int kSmootherReach = 2;
  /// Pixels around a pixel that it takes into account.
  static constexpr int kReach = kStep * (kPattern / 2 + kRefinedReach + kSmootherReach + 1);

  /// All must outlive it. `near`: see LightPoints.
  LightGrid(const SeenBand& band, const RayScene& rays, const Lights& lights, float near);

  /// Shares of the light for something that is seen at pixel (x, y) of the band.
  Lit at(int x, int y, const Seen& seen) const;

 private:
  const Seen& seenAt(int i, int j) const { return band_.at(i * kStep, j * kStep); }
  struct Mean {
    float weights = 0.0F;
    Lit sum{0.0F, 0.0F};
    void add(float weight, const Lit& lit) {
      weights += weight;
      sum.key += weight * lit.key;
      sum.sky += weight * lit.sky;
    }
    Lit lit() const { return {sum.key / weights, sum.sky / weights}; }
  };
  Mean meanAround(int x, int y, int width, const Seen& seen) const;
  void traceRow(int j);
  void refineNarrow();
  void refineShadows();
  float keyShare(const Seen& seen, std::uint32_t pack) const;
  void smoothSky();
  /// Means of `in` for the blocks of columns that have a point with `chosen(index)`.
  template <typename Chosen>
  void averageWhere(const LitPoints& in, int reach, const Chosen& chosen, LitPoints& out) const;
  /// From a pack of points of each light.
  Lit askAlone(const Seen& seen, std::uint32_t pack) const;
  /// What arrives at some surfaces from a point of each light, `xi` for each; at most RayPack::kRays.
  void ask(const Seen* const* seen, const Eigen::Vector2f* xi, int count, Lit* out) const;

  const SeenBand& band_;
  const RayScene& rays_;
  const Lights& lights_;
  LightPoints points_;
  LitPoints raw_, smooth_;
};

}  // namespace proveout::render_detail

// Shares of light over a band of a picture: found by few rays, averaged over each surface.
#pragma once

#include <cmath>
#include <vector>

#include "render/lights.h"
#include "render/surfaces.h"

namespace proveout::render_detail {

/// How much what is seen at one pixel says of another, 0 to 1. `near`: distance across the surface, units,
/// from which on it says nothing.
inline float likeness(const Seen& a, const Seen& b, float near) {
  if (a.what != b.what) return 0.0F;
  if (a.what == Seen::What::kGround) return 1.0F;
  // Surfaces that turn by a twelfth of a cosine say nothing of each other.
  const float alike = 1.0F - 12.0F * (1.0F - a.normal.dot(b.normal));
  const float beside = 1.0F - std::abs(a.normal.dot(b.point - a.point)) / near;
  return alike > 0.0F && beside > 0.0F ? alike * beside : 0.0F;
}

/// Rows of what the pixels see.
struct SeenBand {
  int first = 0, rows = 0, width = 0;
  std::vector<Seen> seen;
  const Seen& at(int x, int y) const { return seen[static_cast<std::size_t>(y - first) * width + x]; }
};

class LightGrid {
 public:
  static constexpr int kStep = 2;     ///< pixels between its points
  static constexpr int kPattern = 7;  ///< points of the grid after which the points of the lights repeat
  static constexpr int kSmootherReach = 2;
  /// Pixels around a pixel that it takes into account.
  static constexpr int kReach = kStep * (kPattern / 2 + kSmootherReach + 1);

  /// All must outlive it. `near`: see likeness.
  LightGrid(const SeenBand& band, const RayScene& rays, const Lights& lights, float near);

  /// Shares of the light for something that is seen at pixel (x, y) of the band.
  Lit at(int x, int y, const Seen& seen) const;

 private:
  const Seen& seenAt(int i, int j) const { return band_.at(i * kStep, j * kStep); }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j - row0_) * columns_ + i; }
  void traceRow(int j);
  void refineShadows();
  float keyShare(const Seen& seen, std::uint32_t pack) const;
  void smoothSky();
  Lit averageAround(const std::vector<Lit>& shares, int i, int j, int reach) const;
  Lit askAlone(const Seen& seen) const;
  /// What arrives at some surfaces from a point of each light, `xi` for each; at most RayPack::kRays.
  void ask(const Seen* const* seen, const Eigen::Vector2f* xi, int count, Lit* out) const;

  const SeenBand& band_;
  const RayScene& rays_;
  const Lights& lights_;
  const float near_;
  int columns_ = 0, row0_ = 0, rows_ = 0;  ///< points: columns from 0, rows from row0_
  std::vector<Lit> raw_, smooth_;
};

}  // namespace proveout::render_detail

// The light on the part: a soft key light that follows the view and the sky. Which share of each arrives at a
// point is found by rays; `ShadowRays` says where they go.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "render/camera.h"

namespace proveout::render_detail {

/// Point k of the additive sequence of the plastic number (Roberts' R2): even in the unit square for any
/// count.
Eigen::Vector2f evenPoint(std::uint32_t k);

/// Shares of the two lights that arrive, 0 to 1.
struct Lit {
  float key = 1.0F, sky = 1.0F;
};

/// Points of the lights are asked for by points of the unit square; even ones there are even ones here.
class Lights {
 public:
  /// `flat`: less contrast, so that heat maps keep the legend's colours, and no highlight.
  Lights(const Camera& camera, bool flat);

  /// Linear colour of a surface of that colour towards the viewer. `normal`: unit.
  Eigen::Vector3f shade(const Eigen::Vector3f& albedo, const Eigen::Vector3f& normal, const Lit& lit) const;
  /// What is left of the light on the ground.
  static float onGround(const Lit& lit);

  /// Whether the key light is above the face.
  bool aboveFace(const Eigen::Vector3f& face) const { return face.dot(key_) > 0; }
  /// Unit vector towards a point of the key light's disc.
  Eigen::Vector3f towardsKey(const Eigen::Vector2f& xi) const;
  /// Towards a point of the sky over a surface, cosine-weighted, above its face.
  static Eigen::Vector3f towardsSky(const Eigen::Vector3f& normal, const Eigen::Vector3f& face,
                                    const Eigen::Vector2f& xi);

  static constexpr float kSkyReach = 0.45F;  ///< units; what is farther does not darken the sky
  static constexpr float kKeyReach = 6.0F;   ///< units; past everything there is

 private:
  Eigen::Vector3f key_, key_a_, key_b_, half_, sky_up_;
  bool flat_;
};

}  // namespace proveout::render_detail

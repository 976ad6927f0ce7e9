#include "render/lights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace proveout::render_detail {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr float kKeyLight = 0.98F;                   ///< irradiance of the key light, facing it
constexpr float kSkyLight = 0.36F;                   ///< irradiance of the sky, unoccluded
constexpr float kHeatKey = 0.66F, kHeatSky = 0.50F;  ///< the same over heat maps
constexpr float kGloss = 0.10F;                      ///< height of the highlight
constexpr int kGlossSquarings = 5;                   ///< its cosine to the power of 32
constexpr float kLightRadius = 0.16F;                ///< of the light's disc at unit distance: soft shadows
constexpr float kGroundShadow = 0.34F, kGroundDirt = 0.42F;

void basisAround(const Vec3f& n, Vec3f& a, Vec3f& b) {
  const Vec3f hint = std::abs(n.z()) < 0.9F ? Vec3f(0, 0, 1) : Vec3f(1, 0, 0);
  a = hint.cross(n).normalized();
  b = n.cross(a);
}

}  // namespace

Eigen::Vector2f evenPoint(std::uint32_t k) {
  const std::uint32_t x = 0x80000000U + (k + 1) * 3242174889U, y = 0x80000000U + (k + 1) * 2447445414U;
  return {static_cast<float>(x >> 8) * 0x1p-24F, static_cast<float>(y >> 8) * 0x1p-24F};
}

Lights::Lights(const Camera& camera, bool flat) : flat_(flat) {
  const Vec3f right = camera.right.cast<float>(), up = camera.up.cast<float>(),
              back = camera.back.cast<float>();
  // From the upper left, over the viewer's shoulder; it follows the view, so that every view reads alike.
  key_ = (right * -0.48F + up * 0.54F + back * 0.69F).normalized();
  basisAround(key_, key_a_, key_b_);
  half_ = (key_ + back).normalized();
  sky_up_ = (up * 0.6F + Vec3f(0, 0, back.z() < -0.5F ? -0.4F : 0.4F)).normalized();
}

Vec3f Lights::shade(const Vec3f& albedo, const Vec3f& normal, const Lit& lit) const {
  float gloss = flat_ ? 0.0F : std::max(0.0F, normal.dot(half_));
  for (int i = 0; i < kGlossSquarings; ++i) gloss *= gloss;
  const float key = (flat_ ? kHeatKey : kKeyLight) * std::max(0.0F, normal.dot(key_)) * lit.key;
  const float sky = (flat_ ? kHeatSky : kSkyLight) * (0.78F + 0.22F * normal.dot(sky_up_)) * lit.sky;
  return albedo * (key + sky) + Vec3f::Constant(kGloss * gloss * key);
}

float Lights::onGround(const Lit& lit) {
  return (1 - kGroundShadow * (1 - lit.key)) * (1 - kGroundDirt * (1 - lit.sky));
}

Vec3f Lights::towardsKey(const Eigen::Vector2f& xi) const {
  const float r = kLightRadius * std::sqrt(xi.x()), angle = 2.0F * static_cast<float>(kPi) * xi.y();
  return (key_ + key_a_ * (r * std::cos(angle)) + key_b_ * (r * std::sin(angle))).normalized();
}

Vec3f Lights::towardsSky(const Vec3f& normal, const Vec3f& face, const Eigen::Vector2f& xi) {
  Vec3f a, b;
  basisAround(normal, a, b);
  const float r = std::sqrt(xi.x()), angle = 2.0F * static_cast<float>(kPi) * xi.y();
  const Vec3f sky =
      a * (r * std::cos(angle)) + b * (r * std::sin(angle)) + normal * std::sqrt(std::max(0.0F, 1 - xi.x()));
  const float below = sky.dot(face);
  return below < 0 ? Vec3f(sky - face * (2 * below)) : sky;
}

}  // namespace proveout::render_detail

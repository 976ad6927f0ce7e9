#include "render/tracer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel_for.h"
#include "render/srgb.h"

namespace proveout::render_detail {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr Rgb kPartColor{0.74F, 0.76F, 0.79F};       ///< sRGB, bare metal
constexpr Rgb kCutColor{0.86F, 0.66F, 0.40F};        ///< sRGB, faces that a section cuts
constexpr Rgb kCutColorInHeat{0.66F, 0.66F, 0.60F};  ///< between the scale's grey and that of "not measured"
constexpr float kHatchPitch = 11.0F, kHatchWidth = 1.2F;  ///< pixels; half the width with its soft edge
constexpr float kHatchDepth = 0.38F;
constexpr float kKeyLight = 0.98F;                   ///< irradiance of the key light, facing it
constexpr float kSkyLight = 0.36F;                   ///< irradiance of the sky, unoccluded
constexpr float kHeatKey = 0.66F, kHeatSky = 0.50F;  ///< flatter, so that heat maps keep the legend's colours
constexpr float kGloss = 0.10F;                      ///< height of the highlight
constexpr float kGlossPower = 24.0F;
constexpr float kLightRadius = 0.16F;  ///< of the light's disc at unit distance: soft shadows
constexpr float kSkyReach = 0.45F;     ///< occluders farther than this (units) do not darken the sky
constexpr float kRayOffset = 1e-4F;    ///< units; float positions and hits are good to about 1e-6
constexpr float kSmooth = 0.02F;  ///< of the scale: vertices that differ by less tell the field between them
constexpr float kSameFace = 0.999F;  ///< cosine between faces that are one for the eye
constexpr float kGroundShadow = 0.34F, kGroundDirt = 0.42F;
constexpr int kFilterRadius = 3;  ///< pixels
constexpr int kBandRows = 192;    ///< rows traced at a time: bounds the memory

/// Sums over the samples of a pixel.
struct PixelSums {
  Vec3f direct = Vec3f::Zero();  ///< colour under the unshadowed key light, linear
  Vec3f sky = Vec3f::Zero();     ///< colour under the open sky, linear
  Vec3f normal = Vec3f::Zero();
  float depth = 0;                      ///< units along the view
  float part = 0, light = 0, open = 0;  ///< samples on the part; of them lit; of them open to the sky
  float ground = 0, ground_light = 0, ground_open = 0;
};

std::uint32_t hash(std::uint32_t x) {  // Bob Jenkins' style avalanche with multipliers by Ellis ("lowbias32")
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  return x ^ (x >> 16);
}

/// Point k of the additive sequence of the plastic number (Roberts' R2), shifted per pixel: even in the unit
/// square for any count, and a function of pixel and index alone.
Eigen::Vector2f evenPoint(std::uint32_t seed, std::uint32_t k) {
  const std::uint32_t x = hash(seed) + (k + 1) * 3242174889U;
  const std::uint32_t y = hash(seed ^ 0x9e3779b9U) + (k + 1) * 2447445414U;
  return {static_cast<float>(x >> 8) * 0x1p-24F, static_cast<float>(y >> 8) * 0x1p-24F};
}

struct Basis {
  Vec3f a, b;
};
Basis basisAround(const Vec3f& n) {
  const Vec3f hint = std::abs(n.z()) < 0.9F ? Vec3f(0, 0, 1) : Vec3f(1, 0, 0);
  const Vec3f a = hint.cross(n).normalized();
  return {a, n.cross(a)};
}

/// Cosine-weighted direction about n.
Vec3f hemisphere(const Vec3f& n, const Eigen::Vector2f& xi) {
  const Basis basis = basisAround(n);
  const float r = std::sqrt(xi.x()), angle = 2.0F * static_cast<float>(kPi) * xi.y();
  return basis.a * (r * std::cos(angle)) + basis.b * (r * std::sin(angle)) +
         n * std::sqrt(std::max(0.0F, 1 - xi.x()));
}

class Tracer {
 public:
  explicit Tracer(const TraceInput& in)
      : in_(in),
        right_(in.camera.right.cast<float>()),
        up_(in.camera.up.cast<float>()),
        back_(in.camera.back.cast<float>()),
        pixel_(static_cast<float>(in.camera.mm_per_pixel / in.rays.radius())),
        heat_(!in.scene.field.values.empty()),
        ground_(in.options.ground && back_.z() > 0.05F) {
    // From the upper left, over the viewer's shoulder; it follows the view, so that every view reads alike.
    light_ = (right_ * -0.48F + up_ * 0.54F + back_ * 0.69F).normalized();
    light_basis_ = basisAround(light_);
    half_ = (light_ + back_).normalized();
    sky_up_ = (up_ * 0.6F + Vec3f(0, 0, back_.z() < -0.5F ? -0.4F : 0.4F)).normalized();
  }

  PixelSums pixel(int x, int y) const {
    PixelSums sums;
    Asked asked;
    const auto pixel_seed =
        hash(static_cast<std::uint32_t>(x) * 0x01000193U ^ hash(static_cast<std::uint32_t>(y)));
    for (int s = 0; s < in_.options.samples; ++s) {
      const auto k = static_cast<std::uint32_t>(s);
      // The same offsets in every pixel: straight edges then step evenly.
      const Eigen::Vector2f at =
          evenPoint(17, k) + Eigen::Vector2f(static_cast<float>(x), static_cast<float>(y));
      sample(at, pixel_seed, k, asked, sums);
    }
    return sums;
  }

  /// Linear colour of the pixel from its sums and the filtered shares of light.
  Vec3f resolve(const PixelSums& sums, const PixelSums& around, const Vec3f& background) const {
    const auto share = [](float part, float whole) { return whole > 0 ? part / whole : 1.0F; };
    const auto count = static_cast<float>(in_.options.samples);
    Vec3f color = sums.direct * share(around.light, around.part) + sums.sky * share(around.open, around.part);
    const float shade = (1 - kGroundShadow * (1 - share(around.ground_light, around.ground))) *
                        (1 - kGroundDirt * (1 - share(around.ground_open, around.ground)));
    color += background * (sums.ground * shade + (count - sums.part - sums.ground));
    return color / count;
  }

 private:
  /// The last value that was asked for in a pixel: rays through it that meet the same face ask once.
  struct Asked {
    std::uint32_t triangle = 0xFFFFFFFFU;
    float value = 0;
  };

  void sample(const Eigen::Vector2f& at, std::uint32_t seed, std::uint32_t k, Asked& asked,
              PixelSums& sums) const {
    const Vec3 on_plane = in_.camera.unproject(at.cast<double>());
    const Vec3f start = in_.rays.toUnit(on_plane);
    const float lift = 2.0F - start.dot(back_);  // the part lies within one unit of its centre
    const Vec3f origin = start + back_ * lift;
    Hit hit;
    if (in_.rays.intersect(origin, -back_, hit)) {
      shadePart(origin - back_ * hit.distance, hit, seed, k, asked, sums);
      return;
    }
    if (ground_) shadeGround(origin, seed, k, sums);
  }

  /// What the ray met: face normal, shading normal, colour.
  struct Surface {
    Vec3f face, normal, albedo;
  };
  Surface surfaceAt(const Vec3f& point, const Hit& hit, Asked& asked) const {
    if (hit.cut_face >= 0) {
      const Vec3f normal = in_.rays.cutNormal(hit.cut_face);
      return {normal, normal, hatch(point, hit.cut_face)};
    }
    Vec3f face = in_.faces[hit.triangle];
    const auto& corner = in_.corners[hit.triangle];
    Vec3f normal = (corner[0] * (1 - hit.u - hit.v) + corner[1] * hit.u + corner[2] * hit.v).normalized();
    if (face.dot(back_) < 0) {  // inside of an open mesh
      face = -face;
      normal = -normal;
    }
    return {face, normal, color(hit, asked)};
  }

  void shadePart(const Vec3f& point, const Hit& hit, std::uint32_t seed, std::uint32_t k, Asked& asked,
                 PixelSums& sums) const {
    const auto [face, normal, albedo] = surfaceAt(point, hit, asked);
    const Vec3f origin = point + face * kRayOffset;
    const float cosine = std::max(0.0F, normal.dot(light_));
    const float gloss = heat_ ? 0.0F : kGloss * std::pow(std::max(0.0F, normal.dot(half_)), kGlossPower);
    sums.direct += (albedo + Vec3f::Constant(gloss)) * ((heat_ ? kHeatKey : kKeyLight) * cosine);
    sums.sky += albedo * ((heat_ ? kHeatSky : kSkyLight) * (0.78F + 0.22F * normal.dot(sky_up_)));
    sums.normal += normal;
    sums.depth += point.dot(back_);
    sums.part += 1;
    if (face.dot(light_) > 0 && !in_.rays.occluded(origin, lightRay(seed, k), 4.0F)) sums.light += 1;
    Vec3f sky = hemisphere(normal, evenPoint(seed ^ 0x5bd1e995U, k));
    if (const float below = sky.dot(face); below < 0) sky -= face * (2 * below);
    if (!in_.rays.occluded(origin, sky, kSkyReach)) sums.open += 1;
  }

  void shadeGround(const Vec3f& origin, std::uint32_t seed, std::uint32_t k, PixelSums& sums) const {
    const float distance = (origin.z() - (in_.rays.floor() - kRayOffset)) / back_.z();
    const Vec3f point = origin - back_ * distance;
    sums.ground += 1;
    if (point.squaredNorm() > 9.0F) {  // nothing within reach can shade it
      sums.ground_light += 1;
      sums.ground_open += 1;
      return;
    }
    if (!in_.rays.occluded(point, lightRay(seed, k), 6.0F)) sums.ground_light += 1;
    const Vec3f sky = hemisphere(Vec3f::UnitZ(), evenPoint(seed ^ 0x5bd1e995U, k));
    if (!in_.rays.occluded(point, sky, kSkyReach)) sums.ground_open += 1;
  }

  Vec3f lightRay(std::uint32_t seed, std::uint32_t k) const {
    const Eigen::Vector2f xi = evenPoint(seed ^ 0x85ebca6bU, k);
    const float r = kLightRadius * std::sqrt(xi.x()), angle = 2.0F * static_cast<float>(kPi) * xi.y();
    return (light_ + light_basis_.a * (r * std::cos(angle)) + light_basis_.b * (r * std::sin(angle)))
        .normalized();
  }

  /// Cut faces carry slanted lines, as on drawings, so that they differ from every colour of the deviations.
  Vec3f hatch(const Vec3f& point, int cut_face) const {
    const float across = cut_face == 0 ? point.y() : point.x();
    const float phase = (across + point.z()) / (1.41421356F * kHatchPitch * pixel_);
    const float from_line = std::abs(phase - std::round(phase)) * kHatchPitch;  // pixels
    const float line = std::clamp(kHatchWidth - from_line, 0.0F, 1.0F);
    return cut_color_ * (1.0F - kHatchDepth * line);
  }

  /// The field at a hit, mm.
  float valueAt(const Hit& hit, Asked& asked) const {
    const ScalarField& field = in_.scene.field;
    if (field.per == ScalarField::Per::kTriangle) return field.values[hit.triangle];
    const auto& t = in_.scene.mesh.triangles[hit.triangle];
    const float a = field.values[t[0]], b = field.values[t[1]], c = field.values[t[2]];
    const float between = a * (1 - hit.u - hit.v) + b * hit.u + c * hit.v;
    if (!field.at) return between;
    const float spread = std::max({a, b, c}) - std::min({a, b, c});
    if (spread < kSmooth * static_cast<float>(field.scale.limit) && longestEdge(t) <= field.largest_mm)
      return between;
    const bool known =
        asked.triangle != 0xFFFFFFFFU && in_.faces[asked.triangle].dot(in_.faces[hit.triangle]) > kSameFace;
    if (!known) asked = {hit.triangle, field.at(pointOf(t, hit))};
    return asked.value;
  }

  /// Of the mesh in mm: exacter than the end of the ray.
  Vec3 pointOf(const std::array<std::uint32_t, 3>& t, const Hit& hit) const {
    const auto& p = in_.scene.mesh.positions;
    const double u = hit.u, v = hit.v;
    return (1.0 - u - v) * p[t[0]].cast<double>() + u * p[t[1]].cast<double>() + v * p[t[2]].cast<double>();
  }

  double longestEdge(const std::array<std::uint32_t, 3>& t) const {
    const auto& p = in_.scene.mesh.positions;
    return std::sqrt(std::max({(p[t[0]] - p[t[1]]).squaredNorm(), (p[t[1]] - p[t[2]]).squaredNorm(),
                               (p[t[2]] - p[t[0]]).squaredNorm()}));
  }

  Vec3f color(const Hit& hit, Asked& asked) const {
    if (heat_) return srgb_.toLinear(deviationColor(in_.scene.field.scale, valueAt(hit, asked)));
    if (!in_.scene.triangle_colors.empty()) return srgb_.toLinear(in_.scene.triangle_colors[hit.triangle]);
    return srgb_.toLinear(kPartColor);
  }

  const TraceInput& in_;
  Vec3f right_, up_, back_, light_, half_, sky_up_;
  Basis light_basis_;
  float pixel_;  ///< units
  bool heat_, ground_;
  SrgbTable srgb_;
  Vec3f cut_color_ = srgb_.toLinear(heat_ ? kCutColorInHeat : kCutColor);
};

/// Rows of sums with the reach of the filter above and below.
struct Band {
  int first = 0, rows = 0, width = 0;
  std::vector<PixelSums> sums;
  const PixelSums& at(int x, int y) const { return sums[static_cast<std::size_t>(y - first) * width + x]; }
};

/// Adds up the light that arrives at the neighbours that show the same smooth surface.
PixelSums gatherAround(const Band& band, int x, int y, float slope_limit) {
  const PixelSums& own = band.at(x, y);
  const Vec3f normal = own.part > 0 ? Vec3f(own.normal / own.part) : Vec3f::Zero();
  const float depth = own.part > 0 ? own.depth / own.part : 0.0F;
  PixelSums around;
  const int y0 = std::max(band.first, y - kFilterRadius),
            y1 = std::min(band.first + band.rows - 1, y + kFilterRadius);
  const int x0 = std::max(0, x - kFilterRadius), x1 = std::min(band.width - 1, x + kFilterRadius);
  for (int v = y0; v <= y1; ++v) {
    for (int u = x0; u <= x1; ++u) {
      const PixelSums& other = band.at(u, v);
      around.ground += other.ground;
      around.ground_light += other.ground_light;
      around.ground_open += other.ground_open;
      if (own.part == 0 || other.part == 0) continue;
      const float inverse = 1.0F / other.part;
      const float bend = 1.0F - normal.dot(other.normal) * inverse;
      const float step = std::abs(other.depth * inverse - depth);
      const float weight = std::max(0.0F, 1.0F - 12.0F * bend) * std::max(0.0F, 1.0F - step / slope_limit);
      around.part += weight * other.part;
      around.light += weight * other.light;
      around.open += weight * other.open;
    }
  }
  if (around.part <= 0) {  // an edge pixel whose normals cancel: its own samples have to do
    around.part = own.part;
    around.light = own.light;
    around.open = own.open;
  }
  return around;
}

}  // namespace

Result<Image> trace(const TraceInput& input, Progress& progress) {
  const Tracer tracer(input);
  const int width = input.size.width, height = input.size.height;
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  const SrgbTable srgb;
  const Vec3f background = srgb.toLinear(input.options.background);
  const float slope_limit = 8.0F * static_cast<float>(input.camera.mm_per_pixel / input.rays.radius());
  for (int y0 = 0; y0 < height; y0 += kBandRows) {
    const int y1 = std::min(height, y0 + kBandRows);
    Band band{std::max(0, y0 - kFilterRadius), 0, width, {}};
    band.rows = std::min(height, y1 + kFilterRadius) - band.first;
    band.sums.resize(static_cast<std::size_t>(band.rows) * width);
    parallelFor(0, band.rows, [&](int row) {
      if (progress.cancelled()) return;
      for (int x = 0; x < width; ++x) {
        band.sums[static_cast<std::size_t>(row) * width + x] = tracer.pixel(x, band.first + row);
      }
    });
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted while drawing"};
    parallelFor(y0, y1, [&](int y) {
      for (int x = 0; x < width; ++x) {
        const Vec3f color = tracer.resolve(band.at(x, y), gatherAround(band, x, y, slope_limit), background);
        std::uint8_t* out = &image.rgb[(static_cast<std::size_t>(y) * width + x) * 3];
        for (int c = 0; c < 3; ++c) out[c] = srgb.toByte(color[c]);
      }
    });
    progress.report("drawing", static_cast<double>(y1) / height);
  }
  return image;
}

}  // namespace proveout::render_detail

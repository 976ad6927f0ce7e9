#include "render/surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace proveout::render_detail {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr Rgb kPartColor{0.74F, 0.76F, 0.79F};       ///< sRGB, bare metal
constexpr Rgb kCutColor{0.86F, 0.66F, 0.40F};        ///< sRGB, faces that a section cuts
constexpr Rgb kCutColorInHeat{0.66F, 0.66F, 0.60F};  ///< between the scale's grey and that of "not measured"
constexpr float kHatchPitch = 11.0F, kHatchWidth = 1.2F;  ///< pixels; half the width with its soft edge
constexpr float kHatchDepth = 0.38F;
constexpr float kSmooth = 0.02F;  ///< of the scale: vertices that differ by less tell the field between them
constexpr float kSameFace = 0.999F;  ///< cosine between faces that are one for the eye

}  // namespace

Surfaces::Surfaces(const RenderScene& scene, const RayScene& rays, const MeshNormals& normals,
                   const Camera& camera)
    : scene_(scene),
      rays_(rays),
      normals_(normals),
      back_(camera.back.cast<float>()),
      pixel_(static_cast<float>(camera.mm_per_pixel / rays.radius())),
      cut_color_(srgb_.toLinear(scene.field.values.empty() ? kCutColor : kCutColorInHeat)),
      part_color_(srgb_.toLinear(kPartColor)) {}

Seen Surfaces::at(const Vec3f& point, const Hit& hit, const Seen* known) const {
  Seen seen;
  seen.what = Seen::What::kPart;
  seen.point = point;
  if (hit.cut_face >= 0) {
    seen.face = seen.normal = rays_.cutNormal(hit.cut_face);
    seen.color = hatch(point, hit.cut_face);
    seen.hatched = true;
    return seen;
  }
  seen.face = normals_.faces[hit.triangle];
  const auto& corner = normals_.corners[hit.triangle];
  seen.normal = (corner[0] * (1 - hit.u - hit.v) + corner[1] * hit.u + corner[2] * hit.v).normalized();
  if (seen.face.dot(back_) < 0) {  // inside of an open mesh
    seen.face = -seen.face;
    seen.normal = -seen.normal;
  }
  seen.color = colorOf(hit, seen.face, known);
  return seen;
}

/// Cut faces carry slanted lines, as on drawings, so that they differ from every colour of the deviations.
Vec3f Surfaces::hatch(const Vec3f& point, int cut_face) const {
  const float across = cut_face == 0 ? point.y() : point.x();
  const float phase = (across + point.z()) / (1.41421356F * kHatchPitch * pixel_);
  const float from_line = std::abs(phase - std::round(phase)) * kHatchPitch;  // pixels
  const float line = std::clamp(kHatchWidth - from_line, 0.0F, 1.0F);
  return cut_color_ * (1.0F - kHatchDepth * line);
}

/// Whether the field goes linearly over a triangle, as far as the eye can tell.
bool Surfaces::linearOver(const std::array<std::uint32_t, 3>& t) const {
  const ScalarField& field = scene_.field;
  const auto [least, most] = std::minmax({field.values[t[0]], field.values[t[1]], field.values[t[2]]});
  if (!(most - least < kSmooth * static_cast<float>(field.scale.limit))) return false;
  const auto& p = scene_.mesh.positions;
  const float longest = std::max({(p[t[0]] - p[t[1]]).squaredNorm(), (p[t[1]] - p[t[2]]).squaredNorm(),
                                  (p[t[2]] - p[t[0]]).squaredNorm()});
  return std::sqrt(longest) <= field.largest_mm;
}

Vec3f Surfaces::colorOf(const Hit& hit, const Vec3f& face, const Seen* known) const {
  const ScalarField& field = scene_.field;
  if (field.values.empty())
    return scene_.triangle_colors.empty() ? part_color_
                                          : srgb_.toLinear(scene_.triangle_colors[hit.triangle]);
  const auto colored = [&](float value) { return srgb_.toLinear(deviationColor(field.scale, value)); };
  if (field.per == ScalarField::Per::kTriangle) return colored(field.values[hit.triangle]);
  const auto& t = scene_.mesh.triangles[hit.triangle];
  const float u = hit.u, v = hit.v;
  if (!field.at || linearOver(t))
    return colored(field.values[t[0]] * (1 - u - v) + field.values[t[1]] * u + field.values[t[2]] * v);
  if (known != nullptr && known->what == Seen::What::kPart && !known->hatched &&
      known->face.dot(face) > kSameFace)
    return known->color;
  // Of the mesh in mm: exacter than the end of the ray.
  const auto& p = scene_.mesh.positions;
  const double a = u, b = v;
  return colored(field.at((1.0 - a - b) * p[t[0]].cast<double>() + a * p[t[1]].cast<double>() +
                          b * p[t[2]].cast<double>()));
}

}  // namespace proveout::render_detail

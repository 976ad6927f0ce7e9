#include "slow_picture.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "core/base/parallel_for.h"
#include "render/lights.h"
#include "render/shading_normals.h"
#include "render/srgb.h"

namespace proveout::test {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr Rgb kMetal{0.74F, 0.76F, 0.79F};  ///< sRGB, of the part

struct Met {
  std::size_t triangle;
  double u, v, distance;
};

class SlowTracer {
 public:
  SlowTracer(const RenderScene& scene, const Camera& camera, const RenderOptions& options)
      : mesh_(scene.mesh),
        camera_(camera),
        lights_(camera, false),
        faces_(render_detail::faceNormals(mesh_)),
        corners_(render_detail::cornerNormals(mesh_, faces_)),
        bounds_(meshBounds(mesh_)),
        radius_(0.5 * bounds_.size().norm()),
        ground_(options.ground && camera.back.z() > 0.05),
        background_(srgb_.toLinear(options.background)) {
    for (const auto& t : mesh_.triangles) {
      const Vec3 a = mesh_.positions[t[0]].cast<double>();
      sides_.push_back(
          {a, mesh_.positions[t[1]].cast<double>() - a, mesh_.positions[t[2]].cast<double>() - a});
    }
  }

  Vector3f pixel(int x, int y, int samples) const {
    std::mt19937 random(static_cast<std::uint32_t>(1000003 * y + x));
    std::uniform_real_distribution<float> even(0.0F, 1.0F);
    const Vector2f in_pixel(even(random), even(random)), key(even(random), even(random)),
        sky(even(random), even(random));
    Vector3f sum = Vector3f::Zero();
    for (int k = 0; k < samples; ++k) {
      const Vector2f p = point(k, in_pixel) + Vector2f(static_cast<float>(x), static_cast<float>(y));
      sum += seenAt(p.cast<double>(), point(7 * k + 3, key), point(5 * k + 1, sky));
    }
    return sum / static_cast<float>(samples);
  }

 private:
  static Vector2f point(int k, const Vector2f& shift) {
    const Vector2f sum = render_detail::evenPoint(static_cast<std::uint32_t>(k)) + shift;
    return {sum.x() - std::floor(sum.x()), sum.y() - std::floor(sum.y())};
  }

  /// T. Moeller, B. Trumbore, 1997.
  std::optional<Met> meet(std::size_t triangle, const Vec3& from, const Vec3& way) const {
    const auto& [a, ab, ac] = sides_[triangle];
    const Vec3 across = way.cross(ac);
    const double scale = ab.dot(across);
    if (scale == 0.0) return std::nullopt;
    const Vec3 off = from - a, turned = off.cross(ab);
    const double u = off.dot(across) / scale, v = way.dot(turned) / scale, t = ac.dot(turned) / scale;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || t <= 0.0) return std::nullopt;
    return Met{triangle, u, v, t};
  }

  bool darkened(const Vec3& from, const Vector3f& way, double reach) const {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto met = meet(t, from, way.cast<double>());
      if (met && met->distance < reach) return true;
    }
    return false;
  }

  render_detail::Lit lightAt(const Vec3& point, const Vector3f& face, const Vector3f& normal,
                             const Vector2f& key, const Vector2f& sky) const {
    const Vec3 from = point + face.cast<double>() * (1e-6 * radius_);
    const Vector3f up = render_detail::Lights::towardsSky(normal, face, sky);
    const bool dark = !lights_.aboveFace(face) || darkened(from, lights_.towardsKey(key), kFar);
    const bool closed = darkened(from, up, render_detail::Lights::kSkyReach * radius_);
    return {dark ? 0.0F : 1.0F, closed ? 0.0F : 1.0F};
  }

  Vector3f seenAt(const Vec2& pixel, const Vector2f& key, const Vector2f& sky) const {
    const Vec3 from = camera_.unproject(pixel) + camera_.back * (4.0 * radius_);
    std::optional<Met> nearest;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto met = meet(t, from, -camera_.back);
      if (met && (!nearest || met->distance < nearest->distance)) nearest = met;
    }
    if (!nearest) return ground_ ? groundAt(from, key, sky) : background_;
    const auto& at = corners_[nearest->triangle];
    const auto u = static_cast<float>(nearest->u), v = static_cast<float>(nearest->v);
    Vector3f face = faces_[nearest->triangle];
    Vector3f normal = (at[0] * (1 - u - v) + at[1] * u + at[2] * v).normalized();
    if (face.dot(camera_.back.cast<float>()) < 0) {
      face = -face;
      normal = -normal;
    }
    const Vec3 point = from - camera_.back * nearest->distance;
    return lights_.shade(srgb_.toLinear(kMetal), normal, lightAt(point, face, normal, key, sky));
  }

  Vector3f groundAt(const Vec3& from, const Vector2f& key, const Vector2f& sky) const {
    const double floor = bounds_.min.z() - 1e-4 * radius_;
    const Vec3 point = from - camera_.back * ((from.z() - floor) / camera_.back.z());
    const Vector3f up = Vector3f::UnitZ();
    return background_ * render_detail::Lights::onGround(lightAt(point, up, up, key, sky));
  }

  struct Sides {
    Vec3 a, ab, ac;
  };

  const TriMesh& mesh_;
  const Camera& camera_;
  const render_detail::Lights lights_;
  const std::vector<Vector3f> faces_;
  const std::vector<std::array<Vector3f, 3>> corners_;
  const Box3 bounds_;
  const double radius_;  ///< mm to a unit of the lights' reaches
  const bool ground_;
  const render_detail::SrgbTable srgb_;
  const Vector3f background_;
  std::vector<Sides> sides_;  ///< by triangle
};

}  // namespace

std::vector<SlowPixel> slowPixels(const RenderScene& scene, const View& view, ImageSize size, int step_x,
                                  int step_y, int samples) {
  const Camera camera = sceneCamera(scene, view, size);
  const SlowTracer tracer(scene, camera, RenderOptions{});
  const render_detail::LinearToByte to_byte;
  std::vector<SlowPixel> pixels;
  for (int y = step_y / 2; y < size.height; y += step_y) {
    for (int x = step_x / 2; x < size.width; x += step_x) pixels.push_back({x, y, {}});
  }
  parallelFor(std::size_t{0}, pixels.size(), [&](std::size_t i) {
    const Vector3f color = tracer.pixel(pixels[i].x, pixels[i].y, samples);
    pixels[i].color = {to_byte(color[0]), to_byte(color[1]), to_byte(color[2])};
  });
  return pixels;
}

}  // namespace proveout::test

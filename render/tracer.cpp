#include "render/tracer.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel_for.h"
#include "render/light_grid.h"
#include "render/srgb.h"

namespace proveout::render_detail {
namespace {

using Vec3f = Eigen::Vector3f;
using What = Seen::What;

constexpr float kGroundGap = 1e-4F;  ///< units under the part
constexpr std::size_t kBandBytes = std::size_t{16} << 20;
constexpr int kBlock = 2;            ///< pixels
constexpr float kEdgeBend = 0.003F;  ///< of a cosine between neighbours that an edge parts
constexpr float kEdgeStep = 1.5F;    ///< pixels across the surface
constexpr float kEdgeColor = 0.02F;  ///< linear
constexpr float kNearPixels = 4.0F;  ///< see likeness
constexpr float kSamePart = 0.9F;    ///< likeness of what one pixel shows: lit alike

/// Written out, as it is asked for four times a pixel: Eigen's stays a call.
float dot(const Vec3f& a, const Vec3f& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }

class Tracer {
 public:
  explicit Tracer(const TraceInput& in)
      : in_(in),
        surfaces_(in.scene, in.rays, in.normals, in.camera),
        lights_(in.camera, !in.scene.field.values.empty()),
        back_(in.camera.back.cast<float>()),
        pixel_(static_cast<float>(in.camera.mm_per_pixel / in.rays.radius())),
        background_(srgb_.toLinear(in.options.background)),
        ground_(in.options.ground && back_.z() > 0.05F) {
    // The picture's plane before the part, which lies within one unit of its centre.
    const Vec3f corner = in.rays.toUnit(in.camera.unproject(Vec2::Zero()));
    corner_ = corner + back_ * (2.0F - corner.dot(back_));
    right_ = in.camera.right.cast<float>() * pixel_;
    down_ = in.camera.up.cast<float>() * -pixel_;
  }

  float nearUnits() const { return kNearPixels * pixel_; }
  const Lights& lights() const { return lights_; }

  /// Fills row y and the one below.
  void seeRows(SeenBand& band, int y) const {
    for (int below = 0; below < kBlock && y + below < band.first + band.rows; ++below) {
      Seen* row = &band.seen[static_cast<std::size_t>(y + below - band.first) * band.width];
      const Seen* first = row - static_cast<std::ptrdiff_t>(below) * band.width;
      for (int x = 0; x < band.width; x += RayPack::kRays) {
        const int count = std::min(RayPack::kRays, band.width - x);
        Points at;
        for (int n = 0; n < count; ++n)
          at[static_cast<std::size_t>(n)] = {static_cast<float>(x + n) + 0.5F,
                                             static_cast<float>(y + below) + 0.5F};
        // Deviations are asked for at one pixel of a block; they were measured no closer.
        const auto known = [&](int n) {
          const int corner = n / kBlock * kBlock;
          return below == 0 && corner == n ? nullptr : first + x + corner;
        };
        see(at, count, known, row + x);
      }
    }
  }

  /// Linear colour of a pixel.
  Vec3f color(const SeenBand& band, const LightGrid& light, int x, int y) const {
    const Seen& middle = band.at(x, y);
    if (const Edge edge = edgeAt(band, x, y); edge != Edge::kNone)
      return colorOfParts(middle, edge == Edge::kColor, light, x, y);
    return middle.what == What::kNothing ? background_ : colorOf(middle, light.at(x, y, middle));
  }

 private:
  using Points = std::array<Eigen::Vector2f, RayPack::kRays>;

  /// What is seen at the first `count` points of the picture (pixels). `known(n)`: see Surfaces::at.
  template <typename Known>
  void see(const Points& at, int count, const Known& known, Seen* out) const {
    RayPack rays;
    for (int n = 0; n < count; ++n) {
      const Eigen::Vector2f& p = at[static_cast<std::size_t>(n)];
      rays.set(n, corner_ + right_ * p.x() + down_ * p.y(), -back_);
    }
    std::array<Hit, RayPack::kRays> hits;
    const std::uint32_t met = in_.rays.intersect(rays, hits);
    for (int n = 0; n < count; ++n) {
      const auto k = static_cast<std::size_t>(n);
      const Vec3f origin(rays.origin[0][k], rays.origin[1][k], rays.origin[2][k]);
      if (met >> k & 1U) {
        out[n] = surfaces_.at(origin - back_ * hits[k].distance, hits[k], known(n));
      } else {
        out[n] = ground_ ? groundBelow(origin) : Seen{};
      }
    }
  }

  Seen groundBelow(const Vec3f& origin) const {
    Seen seen;
    seen.what = What::kGround;
    seen.face = seen.normal = Vec3f::UnitZ();
    seen.point = origin - back_ * ((origin.z() - (in_.rays.floor() - kGroundGap)) / back_.z());
    return seen;
  }

  enum class Edge { kNone, kShape, kColor };
  Edge edgeBetween(const Seen& a, const Seen& b) const {
    if (a.what != b.what) return Edge::kShape;
    if (a.what != What::kPart) return Edge::kNone;
    if (1.0F - dot(a.normal, b.normal) > kEdgeBend || a.hatched != b.hatched) return Edge::kShape;
    if (std::abs(dot(a.normal, b.point - a.point)) > kEdgeStep * pixel_) return Edge::kShape;
    return !a.hatched && (a.color - b.color).cwiseAbs().maxCoeff() > kEdgeColor ? Edge::kColor : Edge::kNone;
  }

  /// Towards the neighbours; kColor if any is.
  Edge edgeAt(const SeenBand& band, int x, int y) const {
    const Seen& own = band.at(x, y);
    Edge edge = Edge::kNone;
    const auto look = [&](int u, int v) {
      if (u < 0 || u >= band.width || v < band.first || v >= band.first + band.rows) return;
      edge = std::max(edge, edgeBetween(own, band.at(u, v)));
    };
    look(x - 1, y);
    look(x + 1, y);
    look(x, y - 1);
    look(x, y + 1);
    return edge;
  }

  Vec3f colorOf(const Seen& seen, const Lit& lit) const {
    if (seen.what == What::kPart) return lights_.shade(seen.color, seen.normal, lit);
    return seen.what == What::kGround ? Vec3f(background_ * Lights::onGround(lit)) : background_;
  }

  /// Of a pixel that shows more than one surface.
  Vec3f colorOfParts(const Seen& middle, bool colors, const LightGrid& light, int x, int y) const {
    Vec3f sum = Vec3f::Zero();
    Seen last;
    Lit lit;
    for (int first = 0; first < in_.options.samples; first += RayPack::kRays) {
      const int count = std::min(RayPack::kRays, in_.options.samples - first);
      Points at;
      std::array<Seen, RayPack::kRays> seen;
      // The same offsets in every pixel: straight edges then step evenly.
      for (int n = 0; n < count; ++n)
        at[static_cast<std::size_t>(n)] = evenPoint(static_cast<std::uint32_t>(first + n)) +
                                          Eigen::Vector2f(static_cast<float>(x), static_cast<float>(y));
      see(
          at, count, [&](int) { return colors ? nullptr : &middle; }, seen.data());
      for (int n = 0; n < count; ++n) {
        const Seen& one = seen[static_cast<std::size_t>(n)];
        if (one.what != What::kNothing && likeness(last, one, nearUnits()) < kSamePart)
          lit = light.at(x, y, one);
        last = one;
        sum += colorOf(one, lit);
      }
    }
    return sum / static_cast<float>(in_.options.samples);
  }

  const TraceInput& in_;
  const Surfaces surfaces_;
  const Lights lights_;
  const Vec3f back_;
  const float pixel_;  ///< units
  const SrgbTable srgb_;
  const Vec3f background_;  ///< linear
  const bool ground_;
  Vec3f corner_, right_, down_;  ///< of the picture's plane, units; a pixel's sides
};

}  // namespace

Result<Image> trace(const TraceInput& input, Progress& progress) {
  const Tracer tracer(input);
  const int width = input.size.width, height = input.size.height;
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  const LinearToByte to_byte;
  const int band_rows = std::max(
      4 * LightGrid::kReach, static_cast<int>(kBandBytes / (sizeof(Seen) * static_cast<std::size_t>(width))));
  SeenBand band{0, 0, width, {}};  // one for all bands: memory that is new costs as much as the rays
  for (int y0 = 0; y0 < height; y0 += band_rows) {
    const int y1 = std::min(height, y0 + band_rows);
    band.first = std::max(0, y0 - LightGrid::kReach);
    band.rows = std::min(height, y1 + LightGrid::kReach) - band.first;
    band.seen.resize(static_cast<std::size_t>(band.rows) * width);
    const int pairs = (band.rows + kBlock - 1) / kBlock;
    parallelFor(0, pairs, [&](int pair) {
      if (!progress.cancelled()) tracer.seeRows(band, band.first + kBlock * pair);
    });
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted while drawing"};
    const LightGrid light(band, input.rays, tracer.lights(), tracer.nearUnits());
    parallelFor(y0, y1, [&](int y) {
      for (int x = 0; x < width; ++x) {
        const Vec3f color = tracer.color(band, light, x, y);
        std::uint8_t* out = &image.rgb[(static_cast<std::size_t>(y) * width + x) * 3];
        for (int c = 0; c < 3; ++c) out[c] = to_byte(color[c]);
      }
    });
    progress.report("drawing", static_cast<double>(y1) / height);
  }
  return image;
}

}  // namespace proveout::render_detail

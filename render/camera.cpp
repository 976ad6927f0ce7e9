#include "render/camera.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/nearest_name.h"

namespace proveout {
namespace {

struct NamedView {
  const char* name;
  double x, y, z;  ///< from the part to the camera, not normalised
  bool section = false;
};
// The iso views look down (or up) at about 33 degrees, a little flatter than the true isometric 35.3, so that
// walls show as well as floors.
constexpr NamedView kViews[] = {
    {"iso", 1, -1.15, 1.0},
    {"iso-left", -1, -1.15, 1.0},
    {"iso-back", -1, 1.15, 1.0},
    {"iso-below", 1, -1.15, -1.0},
    {"top", 0, 0, 1},
    {"bottom", 0, 0, -1},
    {"front", 0, -1, 0},
    {"back", 0, 1, 0},
    {"left", -1, 0, 0},
    {"right", 1, 0, 0},
    {"section", 1, -1.15, 1.0, true},
};

View makeView(const NamedView& named) {
  View view;
  view.name = named.name;
  view.section = named.section;
  view.back = Vec3(named.x, named.y, named.z).normalized();
  const bool vertical = named.x == 0 && named.y == 0;
  const Vec3 hint = vertical ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  view.up = (hint - view.back * hint.dot(view.back)).normalized();
  return view;
}

bool parseSide(const char* first, const char* last, int& value) {
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() && end == last;
}

}  // namespace

Status validateImageSize(ImageSize size) {
  const auto inRange = [](int side) { return side >= kMinImageSide && side <= kMaxImageSide; };
  if (inRange(size.width) && inRange(size.height)) return Done{};
  return inputError(fmt::format("image size {}x{} is out of range: each side must be {} to {} pixels",
                                size.width, size.height, kMinImageSide, kMaxImageSide));
}

Result<ImageSize> parseImageSize(const std::string& text) {
  ImageSize size;
  const std::size_t cross = text.find('x');
  const char* begin = text.data();
  if (cross == std::string::npos || !parseSide(begin, begin + cross, size.width) ||
      !parseSide(begin + cross + 1, begin + text.size(), size.height)) {
    return inputError(
        fmt::format("image size '{}' is not WIDTHxHEIGHT in pixels, for example 1200x900", text));
  }
  if (const Status ok = validateImageSize(size); !ok) return ok.error();
  return size;
}

std::vector<std::string> viewNames() {
  std::vector<std::string> names;
  for (const NamedView& view : kViews) names.emplace_back(view.name);
  return names;
}

Result<View> findView(const std::string& name) {
  for (const NamedView& view : kViews) {
    if (name == view.name) return makeView(view);
  }
  const std::string nearest = nearestName(name, viewNames());
  return inputError(fmt::format("unknown view '{}'{}: the views are {}", name,
                                didYouMean(nearest),
                                fmt::join(viewNames(), ", ")));
}

Result<View> findTurnedView(const std::string& name) {
  const Result<View> usual = findView(name);
  if (!usual) return usual.error();
  // The usual frame has x to the right, y away and z up; here these are Z, -Y and X. Oblique views turn less
  // out of the front view, so that X stays up.
  constexpr double kOblique = 0.45;
  const auto side = [](double v) { return std::abs(v) < 1e-9 ? 0.0 : std::copysign(1.0, v); };
  const Vec3 from(side(usual->back.x()), side(usual->back.y()), side(usual->back.z()));
  const bool oblique = from.cwiseAbs().sum() > 1.5;
  View view = *usual;
  view.back = Vec3(from.z(), -from.y(), from.x());
  if (oblique) view.back = Vec3(kOblique * from.z(), -from.y(), kOblique * from.x());
  view.back.normalize();
  if (std::abs(view.back.z()) > 0.99) {
    view.up = Vec3::UnitX();
    return view;
  }
  const double towards = view.back.y() < -1e-9 ? -1.0 : 1.0;  // from behind +Z lies to the left
  const Vec3 right = towards * (Vec3::UnitZ() - view.back.z() * view.back).normalized();
  view.up = view.back.cross(right);
  return view;
}

Camera fitCamera(const TriMesh& mesh, const View& view, const PixelRect& rect) {
  Camera camera;
  camera.back = view.back;
  camera.up = view.up;
  camera.right = view.up.cross(view.back);
  Box3 seen;  // in camera axes
  for (const Eigen::Vector3f& position : mesh.positions) {
    const Vec3 p = position.cast<double>();
    seen.extend(Vec3(p.dot(camera.right), p.dot(camera.up), p.dot(camera.back)));
  }
  const Vec3 center = seen.center();
  camera.target = camera.right * center.x() + camera.up * center.y() + camera.back * center.z();
  camera.target_pixel = Vec2(0.5 * (rect.x0 + rect.x1), 0.5 * (rect.y0 + rect.y1));
  camera.mm_per_pixel =
      std::max(seen.size().x() / std::max(rect.width(), 1.0), seen.size().y() / std::max(rect.height(), 1.0));
  // A mesh that is a point or is seen edge on still needs a scale.
  if (!(camera.mm_per_pixel > 0)) camera.mm_per_pixel = std::max(seen.size().norm(), 1.0) / 100.0;
  return camera;
}

}  // namespace proveout

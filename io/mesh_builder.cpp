// What the mesh readers share: positions, polygons and text.
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/geometry/ears.h"
#include "io/mesh_formats.h"

namespace proveout::mesh_formats {

namespace {

/// A polygon in its own plane, counter-clockwise, with the indices of its corners.
struct FlatPolygon {
  std::vector<Vec2> points;
  std::vector<std::uint32_t> corners;
  double area2 = 0.0;  ///< twice the area

  std::size_t size() const { return points.size(); }
  /// Twice the area of the triangle at corner i.
  double turn(std::size_t i) const {
    const Vec2& a = points[(i + size() - 1) % size()];
    const Vec2& c = points[(i + 1) % size()];
    return cross2(points[i] - a, c - points[i]);
  }
};

/// Drops the coordinate in which Newell's normal is longest. Planar polygons keep their shape up to a shear.
FlatPolygon flatten(const TriMesh& mesh, std::span<const std::uint32_t> corners) {
  const auto at = [&](std::size_t i) -> Vec3 { return mesh.positions[corners[i]].cast<double>(); };
  Vec3 normal = Vec3::Zero();
  const Vec3 origin = at(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 p = at(i) - origin, q = at((i + 1) % corners.size()) - origin;
    normal +=
        Vec3(p.y() * q.z() - p.z() * q.y(), p.z() * q.x() - p.x() * q.z(), p.x() * q.y() - p.y() * q.x());
  }
  int axis = 0;
  if (std::abs(normal[1]) > std::abs(normal[axis])) axis = 1;
  if (std::abs(normal[2]) > std::abs(normal[axis])) axis = 2;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double flip = normal[axis] < 0.0 ? -1.0 : 1.0;
  FlatPolygon flat;
  flat.area2 = std::abs(normal[axis]);
  flat.corners.assign(corners.begin(), corners.end());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 p = at(i) - origin;
    flat.points.emplace_back(p[u], flip * p[v]);
  }
  return flat;
}

/// Every corner turns left, and so does the fan from the first one; a star turns left at every tip, too.
bool strictlyConvex(const FlatPolygon& flat) {
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (flat.turn(i) <= 0.0) return false;
  }
  for (std::size_t i = 2; i < flat.size(); ++i) {
    if (cross2(flat.points[i - 1] - flat.points[0], flat.points[i] - flat.points[0]) <= 0.0) return false;
  }
  return true;
}

/// Sign of the area of a triangle.
int side(const Vec2& a, const Vec2& b, const Vec2& p) {
  const double area = cross2(b - a, p - a);
  return (area > 0.0) - (area < 0.0);
}

/// Two edges that do not share a corner cross at a point inside both.
bool crossesItself(const FlatPolygon& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = flat.points[i], &b = flat.points[(i + 1) % n];
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Vec2 &c = flat.points[j], &d = flat.points[(j + 1) % n];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
    }
  }
  return false;
}

void addFan(TriMesh& mesh, std::span<const std::uint32_t> corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

/// Cuts ears until a triangle is left. False if there is none to cut: the outline touches or crosses itself.
bool cutEars(TriMesh& mesh, FlatPolygon& flat) {
  while (flat.size() > 3) {
    std::size_t ear = 0;
    while (ear < flat.size() && !isEar(flat.points, ear)) ++ear;
    if (ear == flat.size()) return false;
    const std::size_t n = flat.size();
    mesh.triangles.push_back(
        {flat.corners[(ear + n - 1) % n], flat.corners[ear], flat.corners[(ear + 1) % n]});
    flat.points.erase(flat.points.begin() + static_cast<std::ptrdiff_t>(ear));
    flat.corners.erase(flat.corners.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  addFan(mesh, flat.corners);
  return true;
}

/// What is left has no area to speak of: corners on a line, as CAD systems write them along an edge.
bool isSliver(const FlatPolygon& flat, double whole_area2) {
  return std::abs(signedArea2(flat.points)) <=
         1e-6 * whole_area2;  // single-precision corners carry about 1e-7
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

bool MeshBuilder::addPosition(double x, double y, double z) {
  const Eigen::Vector3f p(static_cast<float>(x * scale), static_cast<float>(y * scale),
                          static_cast<float>(z * scale));
  if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) return false;
  mesh.positions.push_back(p);
  return true;
}

std::string MeshBuilder::addPolygon(std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) return "a face with fewer than three corners: points and lines are not a surface";
  if (corners.size() == 3) {
    addFan(mesh, corners);
    return {};
  }
  FlatPolygon flat = flatten(mesh, corners);
  // Without area the polygon is a folded line. Triangles in it have no area either, yet keep the mesh closed.
  if (flat.area2 <= 0.0 || strictlyConvex(flat)) {
    addFan(mesh, corners);
    return {};
  }
  if (corners.size() > kMaxConcaveCorners) {
    return "a concave face with " + std::to_string(corners.size()) + " corners; at most " +
           std::to_string(kMaxConcaveCorners) + " can be cut into triangles";
  }
  const double whole = flat.area2;
  const char* const kCrossing = "a face whose outline crosses itself";
  if (crossesItself(flat)) return kCrossing;
  if (cutEars(mesh, flat)) return {};
  if (!isSliver(flat, whole)) return kCrossing;
  addFan(mesh, flat.corners);
  return {};
}

std::string_view TextScanner::takeWord() {
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != '\n' && !isBlank(rest_[end])) ++end;
  const std::string_view word = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return word;
}

std::string_view TextScanner::word() {
  while (!rest_.empty() && (rest_.front() == '\n' || isBlank(rest_.front()))) {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }
  return takeWord();
}

std::string_view TextScanner::wordInLine() {
  while (!rest_.empty() && isBlank(rest_.front())) rest_.remove_prefix(1);
  return takeWord();
}

void TextScanner::skipLine() {
  const std::size_t end = rest_.find('\n');
  if (end == std::string_view::npos) {
    rest_ = {};
    return;
  }
  rest_.remove_prefix(end + 1);
  ++line_;
}

std::optional<double> parseReal(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(word).c_str(), nullptr);
  if (error != std::errc{}) return std::nullopt;
  return value;
}

std::string lowerCase(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

}  // namespace proveout::mesh_formats

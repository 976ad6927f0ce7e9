#include "core/mesh/cad_faces.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "core/base/assert.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/turn_counter.h"

namespace proveout {
namespace {

/// The corners of a triangle, the same wherever it begins.
using Corners = std::array<std::array<std::uint32_t, 3>, 3>;

Corners cornersOf(const TriMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  Corners out;
  for (std::size_t c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k)  // 0 and -0 are one place
      out[c][static_cast<std::size_t>(k)] =
          std::bit_cast<std::uint32_t>(mesh.positions[triangle[c]][k] + 0.0f);
  std::sort(out.begin(), out.end());
  return out;
}

struct CornersHash {
  std::size_t operator()(const Corners& corners) const {
    std::uint64_t h = 0x9E3779B97F4A7C15u;
    for (const auto& corner : corners)
      for (const std::uint32_t value : corner) h = (h ^ value) * 0xFF51AFD7ED558CCDu ^ h >> 29;
    return h;
  }
};

}  // namespace

double CadFace::distance(const Vec3& p) const {
  PROVEOUT_ASSERT(kind != SurfaceKind::kOther);
  const Vec3 from = p - origin;
  if (kind == SurfaceKind::kPlane) return from.dot(axis);
  const double along = from.dot(axis), across = (from - along * axis).norm();
  double out = 0.0;
  switch (kind) {
    case SurfaceKind::kCylinder:
      out = across - radius;
      break;
    case SurfaceKind::kCone:
      out = (across - radius) * std::cos(half_angle_rad) - along * std::sin(half_angle_rad);
      break;
    case SurfaceKind::kSphere:
      out = from.norm() - radius;
      break;
    default:
      out = std::hypot(across - radius, along) - tube_radius;
      break;
  }
  return hollow ? -out : out;
}

Vec3 CadFace::normalAt(const Vec3& p) const {
  if (kind == SurfaceKind::kPlane) return axis;
  const Vec3 from = p - origin;
  const double along = from.dot(axis);
  const Vec3 radial = from - along * axis;
  const Vec3 across = radial.norm() > 0.0 ? Vec3(radial.normalized()) : Vec3(axis.unitOrthogonal());
  Vec3 out = across;
  switch (kind) {
    case SurfaceKind::kCone:
      out = std::cos(half_angle_rad) * across - std::sin(half_angle_rad) * axis;
      break;
    case SurfaceKind::kSphere:
      out = from.norm() > 0.0 ? Vec3(from.normalized()) : axis;
      break;
    case SurfaceKind::kTorus:
      out = Vec3(from - radius * across).normalized();
      break;
    default:
      break;
  }
  return hollow ? Vec3(-out) : out;
}

CadFace CadFace::placed(const MeshPlacement& placement) const {
  CadFace out = *this;
  out.origin = placement(origin);
  out.axis = placement.motion().rotation * axis;
  out.radius *= placement.scale;
  out.tube_radius *= placement.scale;
  out.residual_mm *= placement.scale;
  return out;
}

namespace {

/// "X20.000 Y5.000": the coordinates across the axis, or all where it is none of the frame's.
std::string placeAcross(const Vec3& at, const Vec3& axis) {
  int along = -1;
  for (int k = 0; k < 3; ++k)
    if (std::abs(axis[k]) > 1.0 - 1e-9) along = k;
  std::string out;
  for (int k = 0; k < 3; ++k)
    if (k != along) out += fmt::format("{}{}{:.3f}", out.empty() ? "" : " ", "XYZ"[k], at[k] + 0.0);
  return out;
}

std::string planeText(const CadFace& face) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(face.axis[k]) > 1.0 - 1e-9)
      return fmt::format("plane at {}{:.3f}", "XYZ"[k], face.origin[k] + 0.0);
  }
  return fmt::format("plane with the normal {:.4f}, {:.4f}, {:.4f}", face.axis.x(), face.axis.y(),
                     face.axis.z());
}

std::string roundText(const CadFace& face) {
  const std::string at = placeAcross(face.origin, face.axis);
  if (face.isWholeCylinder())
    return fmt::format("{} of diameter {:.6g} at {}", face.hollow ? "hole" : "cylinder", 2.0 * face.radius,
                       at);
  return fmt::format("{} of radius {:.6g} about {}", face.hollow ? "inner round" : "outer round", face.radius,
                     at);
}

}  // namespace

std::string describe(const CadFace& face) {
  std::string out;
  switch (face.kind) {
    case SurfaceKind::kPlane:
      out = planeText(face);
      break;
    case SurfaceKind::kCylinder:
      out = roundText(face);
      break;
    case SurfaceKind::kCone:
      out = fmt::format("{} of {:.6g} degrees at {}", face.hollow ? "countersink" : "cone",
                        2.0 * radToDeg(face.half_angle_rad), placeAcross(face.origin, face.axis));
      break;
    case SurfaceKind::kSphere:
      out = fmt::format("{} of radius {:.6g} about {}", face.hollow ? "hollow sphere" : "sphere", face.radius,
                        placeAcross(face.origin, Vec3::Zero()));
      break;
    case SurfaceKind::kTorus:
      out = fmt::format("{} of radius {:.6g} along a circle of radius {:.6g} about {}",
                        face.hollow ? "inner round" : "outer round", face.tube_radius, face.radius,
                        placeAcross(face.origin, face.axis));
      break;
    default:
      out = "free-form face";
      break;
  }
  return face.name.empty() ? out : fmt::format("{} ({})", out, face.name);
}

CadFaces facesOf(const TriMesh& mesh, const TriMesh& source, CadFaces faces) {
  PROVEOUT_ASSERT(faces.of_triangle.size() == source.triangles.size());
  std::unordered_map<Corners, std::uint32_t, CornersHash> known;
  known.reserve(source.triangles.size());
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
    known.emplace(cornersOf(source, source.triangles[t]), faces.of_triangle[t]);
  faces.of_triangle.assign(mesh.triangles.size(), kNoFace);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto found = known.find(cornersOf(mesh, mesh.triangles[t]));
    if (found != known.end()) faces.of_triangle[t] = found->second;
  }
  return faces;
}

bool isNamed(const CadFace& face, const std::string& name) {
  if (face.name == name) return true;
  return (", " + face.name + ", ").find(", " + name + ", ") != std::string::npos;
}

bool sameSurface(const CadFace& a, const CadFace& b, double near_mm, double near_rad) {
  if (a.kind != b.kind || a.kind == SurfaceKind::kOther || a.hollow != b.hollow) return false;
  const auto near = [&](double x, double y) { return std::abs(x - y) <= near_mm; };
  const Vec3 from = b.origin - a.origin;
  if (a.kind == SurfaceKind::kSphere) return from.norm() <= near_mm && near(a.radius, b.radius);
  const bool directed = a.kind == SurfaceKind::kPlane || a.kind == SurfaceKind::kCone;
  const double dot = a.axis.dot(b.axis);
  if (a.axis.cross(b.axis).norm() > near_rad || (directed && dot < 0.0)) return false;
  const double along = from.dot(a.axis), across = (from - along * a.axis).norm();
  switch (a.kind) {
    case SurfaceKind::kPlane:
      return std::abs(along) <= near_mm;
    case SurfaceKind::kCylinder:
      return across <= near_mm && near(a.radius, b.radius);
    case SurfaceKind::kCone:
      return across <= near_mm && std::abs(a.half_angle_rad - b.half_angle_rad) <= near_rad &&
             near(a.radius + along * std::tan(a.half_angle_rad), b.radius);
    default:
      return across <= near_mm && std::abs(along) <= near_mm && near(a.radius, b.radius) &&
             near(a.tube_radius, b.tube_radius);
  }
}

namespace {

std::string joinedName(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty() || a == b) return a.empty() ? b : a;
  return a + ", " + b;
}

}  // namespace

void countTurns(const TriMesh& mesh, const std::vector<bool>& marked, CadFaces& faces) {
  std::unordered_map<std::uint32_t, TurnCounter> counters;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[t];
    if (face == kNoFace || !marked[face]) continue;
    const CadFace& of = faces.faces[face];
    if (of.kind != SurfaceKind::kCylinder && of.kind != SurfaceKind::kCone) continue;
    std::array<Vec3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = mesh.positions[mesh.triangles[t][c]].cast<double>();
    counters.try_emplace(face, of).first->second.add(corners);
  }
  for (const auto& [face, counter] : counters) faces.faces[face].turn_rad = counter.turn();
}

CadFaces joinedFaces(const TriMesh& mesh, CadFaces faces) {
  PROVEOUT_ASSERT(faces.of_triangle.size() == mesh.triangles.size());
  constexpr double kNearMm = 1e-5, kNearRad = 1e-7;
  DisjointSets sets(faces.faces.size());
  EdgeTable(mesh.positions.size(), mesh.triangles)
      .forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
        if (last - first != 2) return;
        const std::uint32_t a = faces.of_triangle[first[0].half_edge / 3],
                            b = faces.of_triangle[first[1].half_edge / 3];
        if (a == b || a == kNoFace || b == kNoFace || sets.find(a) == sets.find(b)) return;
        if (sameSurface(faces.faces[a], faces.faces[b], kNearMm, kNearRad)) sets.join(a, b);
      });
  if (sets.setsOfSeveral() == 0) return faces;
  std::vector<std::uint32_t> number(faces.faces.size());
  CadFaces out;
  std::vector<bool> joined;
  for (std::uint32_t f = 0; f < number.size(); ++f) {
    const std::uint32_t head = sets.find(f);
    if (head == f) {
      number[f] = static_cast<std::uint32_t>(out.faces.size());
      out.faces.push_back(faces.faces[f]);
      joined.push_back(false);
      continue;
    }
    number[f] = number[head];
    CadFace& into = out.faces[number[f]];
    into.name = joinedName(into.name, faces.faces[f].name);
    joined[number[f]] = true;
  }
  out.chord_mm = faces.chord_mm;
  out.of_triangle = std::move(faces.of_triangle);
  for (std::uint32_t& face : out.of_triangle)
    if (face != kNoFace) face = number[face];
  countTurns(mesh, joined, out);
  return out;
}

}  // namespace proveout

// The machined surface and its volume against closed forms, on a grid that no feature is aligned with.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/geometry/plane.h"
#include "removal/grid/stock.h"
#include "tests/property/accuracy_cases.h"

namespace proveout::accuracy {
namespace {

constexpr double kGrid = 0.2;
// What the engine keeps, mm: of vertices and triangles on faces, and of sharp edges and the triangles along
// them. The tracks of slanted rims, whose radius is below two cells near their ends, are the worst of
// triangles.
constexpr double kFaceVertexMm = 2e-3, kFaceMm = 6e-3, kEdgeVertexMm = 1e-2, kAlongEdgeMm = 1.7e-2,
                 kEdgeMm = 1e-2;
constexpr double kVolume = 1e-5;  ///< of the removed volume, relative

double boxDistance(const BoxShape& box, const Vec3& p) {
  return std::max((box.min - p).maxCoeff(), (p - box.max).maxCoeff());
}

/// How far a point is from the surface of the true part, to first order.
double deviation(const Case& c, const Vec3& p) {
  return std::abs(std::max(boxDistance(c.blank, p), -c.removed(p)));
}

double pointTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  double least = 1e300;
  const std::array<Vec3, 3> corners = {a, b, c};
  bool inside = n.squaredNorm() > 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &from = corners[i], edge = corners[(i + 1) % 3] - from;
    const double length2 = edge.squaredNorm();
    const double s = length2 > 0 ? std::clamp((p - from).dot(edge) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, (p - from - s * edge).norm());
    inside = inside && n.cross(edge).dot(p - from) >= 0;
  }
  return inside ? std::abs(n.normalized().dot(p - a)) : least;
}

struct Measured {
  double face_vertex = 0.0, edge_vertex = 0.0;  ///< largest deviation of vertices: far from edges, near them
  double face_interior = 0.0, edge_interior = 0.0;  ///< of points in triangles, less the chord height
  double edge_missed = 0.0;                         ///< largest distance from a true edge to the mesh
  double volume = 0.0;                              ///< relative error of the removed volume
  double mesh_volume = 0.0;                         ///< error of the mesh's, mm3
  double mesh_volume_bound = 0.0;                   ///< what facets may cost, mm3
};

struct CutPart {
  StockSurface surface;
  double initial_mm3 = 0.0;
};

CutPart cutWith(const Tool& tool, const Case& c, double grid_mm) {
  RemovalOptions options;
  options.resolution_mm = grid_mm;
  Progress progress;
  CutPart part;
  auto stock = Stock::create(c.blank, options, progress);
  EXPECT_TRUE(stock.ok()) << stock.error().message;
  if (!stock) return part;
  const auto removed = stock->remove(c.path, {tool}, options, progress);
  EXPECT_TRUE(removed.ok()) << removed.error().message;
  SurfaceOptions fine;
  fine.simplify_mm = 0.0;
  auto surface = stock->surface(fine, progress);
  EXPECT_TRUE(surface.ok()) << surface.error().message;
  if (surface) part.surface = std::move(*surface);
  part.initial_mm3 = stock->initialVolume();
  return part;
}

CutPart cutCase(const Case& c, double grid_mm = kGrid) {
  return cutWith(parseToolOption(c.tool).value(), c, grid_mm);
}

/// Points inside a triangle, as weights of its corners.
constexpr double kInside[][3] = {{1. / 3, 1. / 3, 1. / 3},
                                 {.5, .5, 0},
                                 {0, .5, .5},
                                 {.5, 0, .5},
                                 {.6, .2, .2},
                                 {.2, .6, .2},
                                 {.2, .2, .6}};

void measureTriangle(const Case& c, const Vec3& p0, const Vec3& p1, const Vec3& p2, Measured& m) {
  for (const Vec3& p : {p0, p1, p2}) {
    double& worst = c.edge_distance(p) > kGrid ? m.face_vertex : m.edge_vertex;
    worst = std::max(worst, deviation(c, p));
  }
  double chord = 0.0;
  for (const auto& w : kInside) {
    const Vec3 p = w[0] * p0 + w[1] * p1 + w[2] * p2;
    const double height = kGrid * kGrid / (8 * c.curvature_radius(p));
    chord = std::max(chord, height);
    // A triangle on an edge has its interior judged with the edge.
    const double from_edge =
        std::min({c.edge_distance(p), c.edge_distance(p0), c.edge_distance(p1), c.edge_distance(p2)});
    double& worst = from_edge > kGrid ? m.face_interior : m.edge_interior;
    worst = std::max(worst, deviation(c, p) - height);
  }
  m.mesh_volume_bound += 0.5 * (p1 - p0).cross(p2 - p0).norm() * chord;
}

/// Largest distance of the case's edge points from the mesh.
double edgeMissed(const Case& c, const TriMesh& mesh) {
  const double reach = kGrid;  // farther than this counts as this
  double worst = 0.0;
  for (const Vec3& point : c.edge_points) {
    double least = reach;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.positions[t[0]].cast<double>();
      if ((a - point).cwiseAbs().maxCoeff() > 8 * reach) continue;
      least = std::min(least, pointTriangle(point, a, mesh.positions[t[1]].cast<double>(),
                                            mesh.positions[t[2]].cast<double>()));
    }
    worst = std::max(worst, least);
  }
  return worst;
}

Measured measure(const Case& c) {
  Measured m;
  const CutPart part = cutCase(c);
  const TriMesh& mesh = part.surface.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.motion[t] == kNoMotion) continue;
    const auto& v = mesh.triangles[t];
    measureTriangle(c, mesh.positions[v[0]].cast<double>(), mesh.positions[v[1]].cast<double>(),
                    mesh.positions[v[2]].cast<double>(), m);
  }
  m.edge_missed = edgeMissed(c, mesh);
  m.volume = (part.initial_mm3 - part.surface.volume_mm3) / c.removed_mm3 - 1.0;
  m.mesh_volume = meshVolume(mesh) - (part.initial_mm3 - c.removed_mm3);
  m.mesh_volume_bound += kVolume * c.removed_mm3;
  return m;
}

class StockAccuracy : public testing::TestWithParam<Case> {};

TEST_P(StockAccuracy, StaysWithinItsBounds) {
  const Case& c = GetParam();
  const Measured m = measure(c);
  std::printf(
      "%-16s vertex %6.2f / %6.2f um, interior over chord %6.2f / %6.2f um, edge %6.2f um, "
      "volume %9.1e, mesh %8.4f of %.4f mm3\n",
      c.name.c_str(), 1e3 * m.face_vertex, 1e3 * m.edge_vertex, 1e3 * m.face_interior, 1e3 * m.edge_interior,
      1e3 * m.edge_missed, m.volume, m.mesh_volume, m.mesh_volume_bound);
  EXPECT_GT(c.removed_mm3, 1.0);
  EXPECT_LE(m.face_vertex, kFaceVertexMm);
  EXPECT_LE(m.edge_vertex, kEdgeVertexMm);
  EXPECT_LE(m.face_interior, kFaceMm);
  EXPECT_LE(m.edge_interior, kAlongEdgeMm);
  EXPECT_LE(m.edge_missed, kEdgeMm);
  EXPECT_LE(std::abs(m.volume), kVolume);
  EXPECT_LE(std::abs(m.mesh_volume), m.mesh_volume_bound);
}

INSTANTIATE_TEST_SUITE_P(Cuts, StockAccuracy, testing::ValuesIn(allCases()),
                         [](const auto& test) { return test.param.name; });

/// A cutter and how deep it goes, on a grid of 0.25 mm.
struct Groove {
  std::string tool;
  Outline outline;
  double depth;
};

void addGrooves(std::vector<Groove>& grooves, const std::string& tool, const Outline& outline,
                std::initializer_list<double> depths) {
  for (const double depth : depths) grooves.push_back({tool, outline, depth});
}

std::vector<Groove> grooves() {
  std::vector<Groove> out;
  const auto add = [&](const std::string& tool, const Outline& outline,
                       std::initializer_list<double> depths) { addGrooves(out, tool, outline, depths); };
  for (const double d : {9.0, 10.0, 12.0, 16.0})
    add(fmt::format("1=ball:{:g}", d), ballOutline(d), {1.0, 1.79, 2.0, 3.0});
  for (const double c : {1.5, 2.5, 4.0})
    add(fmt::format("1=bull:10:{:g}", c), bullOutline(10.0, c), {0.7, 1.79, 3.0});
  for (const double side : {5.0, 15.0, 30.0})
    add(fmt::format("1=taper:6:{:g}:12", side), taperOutline(6.0, side, 12.0), {1.0, 1.79, 3.0});
  for (const double angle : {90.0, 118.0, 140.0})
    add(fmt::format("1=drill:14:{:g}", angle), drillOutline(14.0, angle), {1.0, 1.79, 2.5});
  return out;
}

/// Of tools whose round elements are few cells large and go over into straight ones.
std::vector<Groove> fineGrooves() {
  std::vector<Groove> out;
  for (const double d : {2.6, 3.7, 5.3})
    addGrooves(out, fmt::format("1=ball:{:g}", d), ballOutline(d), {0.9, 0.5 * d + 0.163, 0.5 * d + 0.8});
  for (const double c : {1.0, 1.3})
    addGrooves(out, fmt::format("1=bull:5:{:g}", c), bullOutline(5.0, c), {0.8, c + 0.163, c + 0.8});
  return out;
}

/// Spread evenly in [0, 1).
double part(int i, double step) { return std::fmod(i * step, 1.0); }

/// Round faces of many cells show at their rims in most cells by one crossing: what they bend off its plane
/// lies to one side all along.
class GrooveVolume : public testing::Test {
 protected:
  static constexpr double kCoarse = 0.25, kPointCells = 0.04;
  static void expectExact(const Groove& groove, const std::string& way, const Case& c) {
    const CutPart part = cutCase(c, kCoarse);
    const double off = (part.initial_mm3 - part.surface.volume_mm3) / c.removed_mm3 - 1.0;
    std::printf("%-14s %g deep, %s: volume %9.1e\n", groove.tool.c_str(), groove.depth, way.c_str(), off);
    // Beside the point of a cone nothing in a cell is quadratic.
    const bool pointed = groove.outline.lower(1e-9) > 1e-10;
    const double point = pointed ? kPointCells * std::pow(kCoarse, 3) : 0.0;
    EXPECT_LE(std::abs(off) * c.removed_mm3, kVolume * c.removed_mm3 + point)
        << groove.tool << " " << groove.depth << " " << way;
  }
  void expectExactLevel(const std::vector<Groove>& grooves) const {
    for (const Groove& g : grooves) {
      const Toolpath path = linePath({{from.x(), from.y(), -g.depth}, {to.x(), to.y(), -g.depth}});
      expectExact(g, "level", levelCase("", g.tool, g.outline, segmentCurve(from, to), path, -g.depth));
    }
  }
  void expectExactOnASlope(const std::vector<Groove>& grooves) const {
    for (const Groove& g : grooves) {
      const Vec3 high(from.x(), from.y(), -0.4 * g.depth), low(to.x(), to.y(), -g.depth);
      expectExact(g, "on a slope", slantedCase("", g.tool, g.outline, high, low));
    }
  }
  void expectExactHoles(const std::vector<Groove>& grooves) const {
    for (const Groove& g : grooves) {
      const Toolpath path = linePath({{center.x(), center.y(), 3.0}, {center.x(), center.y(), -g.depth}});
      expectExact(g, "a hole", levelCase("", g.tool, g.outline, pointCurve(center), path, -g.depth));
    }
  }
  const Vec2 along{std::cos(degToRad(23.7)), std::sin(degToRad(23.7))};
  const Vec2 center{14.953, 12.421}, from = center - 7.3 * along, to = center + 7.9 * along;
};

TEST_F(GrooveVolume, Level) { expectExactLevel(grooves()); }
TEST_F(GrooveVolume, OnASlope) { expectExactOnASlope(grooves()); }

// Quads across two elements took one curvature for both: up to 3e-5 of a ball deeper than its radius.
TEST_F(GrooveVolume, FineLevel) { expectExactLevel(fineGrooves()); }
TEST_F(GrooveVolume, FineOnASlope) { expectExactOnASlope(fineGrooves()); }

TEST_F(GrooveVolume, Hole) { expectExactHoles(grooves()); }

// Walls were of the rim of the ball as much as of the shank, so that no border was known: up to 1.8e-4.
TEST_F(GrooveVolume, FineHole) {
  std::vector<Groove> holes;
  for (const double d : {2.6, 3.1, 3.7, 5.3})
    addGrooves(holes, fmt::format("1=ball:{:g}", d), ballOutline(d), {0.5 * d + 0.37, 0.5 * d + 0.9});
  expectExactHoles(holes);
}

// Chords of rims left out slivers, rims that bend much stayed where their planes meet, and vertices at a wall
// of their cell were up to 0.05 cells off: up to 6e-4.
TEST_F(GrooveVolume, Dimple) {
  constexpr int kDimples = 120;
  double sum = 0.0, worst_vertex = 0.0;
  for (int i = 0; i < kDimples; ++i) {
    const double d = 2.0 + 2.0 * part(i, 0.6180339887),
                 depth = 0.5 * d * (0.3 + 0.65 * part(i, 0.7548776662));
    const Vec2 at(14.9 + 0.25 * part(i, 0.5698402910), 12.4 + 0.25 * part(i, 0.8191725134));
    const Case c = levelCase("", fmt::format("1=ball:{:g}", d), ballOutline(d), pointCurve(at),
                             linePath({{at.x(), at.y(), 3.0}, {at.x(), at.y(), -depth}}), -depth);
    const CutPart cut = cutCase(c, kCoarse);
    const double off = (cut.initial_mm3 - cut.surface.volume_mm3) / c.removed_mm3 - 1.0;
    EXPECT_LE(std::abs(off), 1.2e-4) << d << " " << depth;
    sum += std::abs(off);
    for (const auto& position : cut.surface.mesh.positions) {
      const Vec3 p = position.cast<double>();
      if (p.z() < -3.0 || (p.head<2>() - at).norm() > d) continue;
      worst_vertex = std::max(worst_vertex, std::abs(std::max(p.z(), -c.removed(p))));
    }
  }
  std::printf("dimples: mean %.1e, vertices %.2f um\n", sum / kDimples, 1e3 * worst_vertex);
  EXPECT_LE(sum / kDimples, 1.5e-5);
  EXPECT_LE(worst_vertex, 1e-3);
}

/// Tips of drills anywhere between the grid's lines. The drill is drawn back through its hole, so that every
/// face is that of two motions.
TEST(StockAccuracy, DrillTipsAreSharpAndNothingBesideThemIsOff) {
  const double slope = std::tan(degToRad(31.0)), radius = 1.5;
  std::vector<Vec3> tips;
  std::vector<Vec3> way;
  for (int i = 0; i < 100; ++i) {
    const double x = 4.0 * (i % 10) + 2.5 + std::fmod(i * 0.6180339887, 1.0) * kGrid;
    const double y = 4.0 * (i / 10) + 2.5 + std::fmod(i * 0.7548776662, 1.0) * kGrid;
    tips.emplace_back(x, y, -4.0 - std::fmod(i * 0.5698402910, 1.0) * kGrid);
    for (const double z : {2.0, tips.back().z(), 2.0}) way.emplace_back(x, y, z);
  }
  Case c;
  c.blank = BoxShape{{0, 0, -6}, {42, 42, 0}};
  c.tool = "1=drill:3:118";
  c.path = linePath(way);
  const TriMesh mesh = cutCase(c).surface.mesh;
  double face = 0.0, near_tip = 0.0;
  std::vector<double> missed(tips.size(), 1e300);
  for (const auto& position : mesh.positions) {
    const Vec3 p = position.cast<double>();
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const Vec3 d = p - tips[i];
      const double r = std::hypot(d.x(), d.y());
      if (r > radius - kGrid || p.z() > -1.0 || p.z() < -5.5) continue;
      double& worst = d.norm() > kGrid ? face : near_tip;
      worst = std::max(worst, std::abs(d.z() - slope * r) * std::cos(degToRad(31.0)));
      missed[i] = std::min(missed[i], d.norm());
    }
  }
  const double blunt = *std::max_element(missed.begin(), missed.end());
  std::printf("drill tips: vertices %.2f / %.2f um off, tips missed by %.2f um\n", 1e3 * face, 1e3 * near_tip,
              1e3 * blunt);
  EXPECT_LE(face, kFaceVertexMm);
  EXPECT_LE(near_tip, kEdgeVertexMm);
  EXPECT_LE(blunt, kEdgeMm);
}

/// Signed distance to a bull nose (radius, of its corner) that goes level along a way, its tip at height 0.
double bullDistance(double radius, double corner, double beside, double z) {
  const Vec2 out(std::max(beside - (radius - corner), 0.0), std::max(corner - z, 0.0));
  return out.isZero() ? std::max(beside - radius, -z) : out.norm() - corner;
}

/// A bull nose goes down and on in two directions: cells in which floors and corners of several motions go
/// over into each other without a break.
TEST(StockAccuracy, VerticesAreOnFacesThatGoOverIntoEachOther) {
  constexpr double kRadius = 3.5, kCorner = 1.45;
  double worst = 0.0;
  for (int i = 0; i < 20; ++i) {
    const double turn = 0.3 * i, z = -3.0 - 0.0137 * i;
    const std::vector<Vec3> at = {{12, 12, 2},
                                  {12, 12, z},
                                  {12 + 6 * std::cos(turn), 12 + 6 * std::sin(turn), z},
                                  {12 + 5 * std::cos(2.7 * turn), 12 + 5 * std::sin(2.7 * turn), z}};
    Case c;
    c.blank = BoxShape{{0, 0, -6}, {24, 24, 0}};
    c.tool = "1=bull:7:1.45";
    c.path = linePath(at);
    for (const auto& position : cutCase(c, 0.25).surface.mesh.positions) {
      const Vec3 p = position.cast<double>();
      if (p.z() < z - 0.01 || p.z() > -0.3) continue;  // the block's own
      double least = 1e300;
      for (std::size_t k = 1; k < at.size(); ++k) {
        const Vec2 from = at[k == 1 ? 1 : k - 1].head<2>(), to = at[k].head<2>();
        least = std::min(least,
                         bullDistance(kRadius, kCorner, distanceToSegment(p.head<2>(), from, to), p.z() - z));
      }
      if (least < 1.0) worst = std::max(worst, std::abs(least));
    }
  }
  std::printf("faces that go over into each other: vertices %.2f um off\n", 1e3 * worst);
  EXPECT_LE(worst, kFaceVertexMm);
}

/// The crests that a thread mill leaves end up to 0.87 cells beside the nearest samples.
TEST(StockAccuracy, CrestsBetweenTheTeethOfAThreadMillAreSharp) {
  constexpr double kRadius = 3.0, kPitch = 1.5;
  const double slope = std::sqrt(3.0);  // of 60 degrees between the flanks
  Tool mill;
  mill.number = 1;
  mill.type = ToolType::kThreadMill;
  mill.diameter = 2 * kRadius;
  mill.pitch = kPitch;
  mill.teeth = 3;
  double worst = 0.0;
  int at_crests = 0;
  for (int i = 0; i < 12; ++i) {
    const double tip = -5.0 - 0.25 * part(i, 0.618), angle = kPi / 2 * part(i, 0.382);
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0), middle(12, 12, tip);
    Case c;
    c.blank = BoxShape{{0, 0, -6}, {24, 24, 0}};
    c.path = linePath({middle - 30.0 * along, middle + 30.0 * along});
    for (const auto& position : cutWith(mill, c, 0.25).surface.mesh.positions) {
      const Vec3 p = position.cast<double>();
      const double up = (p.z() - tip) / kPitch;  // teeth
      if (up < 0.2 || up > 2.8 || boxDistance(c.blank, p) > -0.5) continue;
      const double from_tooth = kPitch * std::abs(up - std::floor(up) - 0.5);
      const double beside = std::abs((p - middle).dot(Vec3(-along.y(), along.x(), 0.0)));
      worst = std::max(worst, 0.5 * std::abs(beside - (kRadius - slope * from_tooth)));
      at_crests += from_tooth > 0.5 * kPitch - 1e-3 ? 1 : 0;
    }
  }
  std::printf("crests of a thread mill: vertices %.2f um off, %d on crests\n", 1e3 * worst, at_crests);
  EXPECT_GT(at_crests, 500);
  EXPECT_LE(worst, kFaceVertexMm);
}

/// The reference volumes themselves, where a simple formula exists beside the integral.
TEST(AccuracyCases, IntegralsMatchFormulas) {
  const auto volume = [](const std::string& name) {
    for (const Case& c : allCases()) {
      if (c.name == name) return c.removed_mm3;
    }
    return 0.0;
  };
  const double d = 4.117, length = 15.2;
  EXPECT_NEAR(volume("PlungeFlat"), kPi * 9 * d, 1e-7);
  EXPECT_NEAR(volume("PlungeBall"), kPi * 9 * (d - 3) + 18 * kPi, 1e-7);
  EXPECT_NEAR(volume("SlotFlat"), (kPi * 9 + 6 * length) * d, 1e-7);
  EXPECT_NEAR(volume("RingBall"), 2 * kPi * 7.177 * (6 * (d - 3) + 4.5 * kPi), 1e-6);
  const double tip = 1.0, wide = tip + d * std::tan(kPi / 6);  // frustum
  EXPECT_NEAR(volume("PlungeCone"), kPi * d / 3 * (tip * tip + tip * wide + wide * wide), 1e-6);
}

/// The integral of a slanted slot against the engine-free truth in another way: columns counted on a fine
/// net.
TEST(AccuracyCases, SlantedVolumesMatchCountedColumns) {
  for (const Case& c : allCases()) {
    if (c.name.rfind("Slanted", 0) != 0) continue;
    const double step = 0.17;
    double sum = 0.0;
    for (double x = c.blank.min.x() + step / 2; x < c.blank.max.x(); x += step) {
      for (double y = c.blank.min.y() + step / 2; y < c.blank.max.y(); y += step) {
        if (c.removed({x, y, 0.0}) > 0) continue;
        double in = 0.0, out = c.blank.min.z();
        for (int i = 0; i < 16; ++i) {
          const double z = 0.5 * (in + out);
          (c.removed({x, y, z}) <= 0 ? in : out) = z;
        }
        sum -= in * step * step;
      }
    }
    EXPECT_NEAR(sum / c.removed_mm3, 1.0, 3e-3) << c.name;
  }
}

}  // namespace
}  // namespace proveout::accuracy

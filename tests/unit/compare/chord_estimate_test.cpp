// How high the chords of a nominal are told to be, against what they are: many shapes, sizes and manners of
// tessellation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "removal/compare/compare.h"
#include "removal/compare/shape/nominal_shape.h"
#include "tests/support/lofts.h"
#include "tests/support/tessellations.h"
#include "tests/unit/compare/shapes.h"

namespace proveout {
namespace {

using namespace tessellations;

const char* nameOf(Manner m) {
  return m == Manner::kFan ? "fan" : m == Manner::kStrips ? "strips" : "irregular";
}

/// What the facets were read as.
struct Told {
  double chord = 0.0;     ///< largest, mm
  double truth = 0.0;     ///< the same of the true surface
  double residual = 0.0;  ///< largest distance between the face as read and the true one
  double unsure = 0.0;    ///< largest distance beyond both readings
  double within = 0.0;    ///< the same as a share of what is told to be unsure, its largest
  double bound = 0.0;     ///< what is told to be unsure, mean over the curved facets
};

Told read(const Facets& f) {
  const SurfaceMesh points = shapes::surface(f.mesh);
  const SignedDistance distance(points);
  const NominalShape shape(points, distance);
  Told out;
  out.chord = std::max(shape.largest(), shape.largestDoubt());
  double sum = 0.0, area = 0.0;
  constexpr int kSteps = 8;
  for (std::uint32_t t = 0; t < points.triangles.size(); ++t) {
    const auto& v = points.triangles[t];
    const double unsure = shape.unsureAt(t, points.middle(t), 0.1);
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vec3 p = points.points[v[0]] + (points.points[v[1]] - points.points[v[0]]) * i / kSteps +
                       (points.points[v[2]] - points.points[v[0]]) * j / kSteps;
        const double beyond = f.beyond(p), told = shape.at(t, p);
        out.truth = std::max(out.truth, std::abs(beyond));
        out.residual = std::max(out.residual, std::abs(beyond - told));
        const double apart = std::max({0.0, beyond - std::max(told, 0.0), std::min(told, 0.0) - beyond});
        out.unsure = std::max(out.unsure, apart);
        if (apart > 1e-5) out.within = std::max(out.within, apart / (unsure + 1e-5));
        if (beyond == 0.0) continue;
        const double weight = points.areaVector(t).norm();
        sum += weight * unsure;
        area += weight;
      }
    }
  }
  out.bound = sum / std::max(area, 1e-30);
  return out;
}

struct Row {
  std::string text;
  double ratio, within;
};

Row report(const Facets& f, const std::string& how) {
  const Told told = read(f);
  const double ratio = told.chord / told.truth;
  fmt::print(
      "{:<14} {:<34} chord {:8.5f} told {:8.5f} ratio {:6.3f} misread {:6.3f} beyond {:6.3f} "
      "of bound {:6.3f} mean bound {:6.3f}\n",
      f.name, how, told.truth, told.chord, ratio, told.residual / told.truth, told.unsure / told.truth,
      told.within, told.bound / told.truth);
  return {f.name + ", " + how, ratio, told.within};
}

constexpr double kChords[] = {0.002, 0.005, 0.02, 0.05};
constexpr Manner kManners[] = {Manner::kFan, Manner::kStrips, Manner::kIrregular};

/// `rough`: facets without order, or cut by others; what they leave open is shown by comparisons below.
void expectRight(const Row& row, bool rough = false) {
  EXPECT_GT(row.ratio, 0.7) << row.text;
  EXPECT_LT(row.ratio, 1.5) << row.text;
  if (!rough) {
    EXPECT_LT(row.within, 1.0) << row.text;
  }
}

TEST(ChordEstimate, BodiesOfRevolution) {
  for (const Manner manner : kManners) {
    for (const double chord : kChords) {
      for (const double r : {0.5, 3.0, 12.0, 60.0}) {
        const int n = 4 * ((fragmentsFor(r, chord) + 3) / 4);
        const bool rough = manner == Manner::kIrregular;
        if (n > 200 || (rough && n < 12)) continue;
        const std::string how = fmt::format("{} R{} {} fragments", nameOf(manner), r, n);
        expectRight(report(cylinder(r, 2.5 * r, n, manner), how), rough);
        expectRight(report(cone(r, 0.4 * r, r, n, manner), how), rough);
        expectRight(report(cone(r, 0.0, 1.5 * r, n, manner), how), rough);
        if (n <= 120) expectRight(report(sphere(r, n, manner), how), rough);
        const int tube = fragmentsFor(0.3 * r, chord);
        if (n <= 120 && tube >= 12) expectRight(report(torus(r, 0.3 * r, n, tube, manner), how), rough);
        if (fragmentsFor(0.4 * r, chord) >= 12)
          expectRight(report(pin(r, 0.4 * r, 4 * r, chord, manner), how), rough);
      }
    }
  }
}

TEST(ChordEstimate, FreeFormPatches) {
  for (const Manner manner : {Manner::kFan, Manner::kIrregular}) {
    for (const int steps : {12, 24, 48}) {
      for (const double amplitude : {0.3, 1.0}) {
        expectRight(report(wavyBlock(24.0, amplitude, 20.0, steps, manner),
                           fmt::format("{} {} steps, waves of {}", nameOf(manner), steps, amplitude)),
                    true);
      }
    }
  }
}

TEST(ChordEstimate, CoarsePolygons) {
  for (const int n : {8, 9, 10, 12, 14, 16, 24, 30}) {
    for (const double r : {0.5, 1.0, 2.0, 3.0, 5.0}) {
      const double chord = r * (1.0 - std::cos(kPi / n));
      if (chord > 0.25) continue;
      expectRight(report(cylinder(r, 8.0, n, Manner::kFan), fmt::format("R{} {} fragments", r, n)));
    }
  }
}

/// Halves of balls of evenly split octahedra, with the strips of a cylinder between them.
TriMesh geodesicCapsule(double radius, double axis_z, double half, double chord) {
  int levels = 2;
  while (radius * (1 - std::cos(0.25 * kPi / (1 << levels))) > chord) ++levels;
  const TriMesh ball = shapes::sphere({0, 0, 0}, radius, levels);
  Soup soup;
  const auto at = [&](std::uint32_t v, double to) {
    return Vec3(ball.positions[v].cast<double>() + Vec3(to, 0, axis_z));
  };
  for (const auto& t : ball.triangles) {
    const double middle = ball.positions[t[0]].x() + ball.positions[t[1]].x() + ball.positions[t[2]].x();
    const double to = middle > 0 ? half : -half;
    soup.add(at(t[0], to), at(t[1], to), at(t[2], to));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t[c], b = t[(c + 1) % 3];
      const auto seam = [&](std::uint32_t v) { return std::abs(ball.positions[v].x()) < 1e-6; };
      if (middle > 0 && seam(a) && seam(b))
        soup.add(at(b, half), at(a, half), at(a, -half), at(b, -half), false);
    }
  }
  return soup.mesh();
}

/// A groove that a ball left: a straight channel with spherical ends, its axis at `depth` below the top.
Facets groove(double radius, double axis_z, double length, double chord, int form) {
  const double bottom = axis_z - radius;
  const double half = 0.5 * length;
  TriMesh tool;
  if (form == 0) {  // hull of two balls: rings about Z
    Section s;
    addArc(s, {0, axis_z}, radius, -90, 90, piecesFor(radius, chord, 180));
    lofts::Profile profile;
    for (const Vec2& p : s) profile.line(p.x(), p.y());
    tool = lofts::solid(profile, {half, 0}, chord);
  } else if (form == 3) {
    tool = geodesicCapsule(radius, axis_z, half, chord);
  } else {  // turned about the groove's axis
    Section s;
    addArc(s, {0, -half}, radius, -90, 0, piecesFor(radius, chord, 90));
    addArc(s, {0, half}, radius, 0, 90, piecesFor(radius, chord, 90));
    tool = revolve(s, 4 * ((fragmentsFor(radius, chord) + 3) / 4),
                   form == 1 ? Manner::kStrips : Manner::kIrregular);
    for (auto& p : tool.positions) p = Eigen::Vector3f(p.z(), p.y(), static_cast<float>(axis_z) - p.x());
  }
  const TriMesh block =
      shapes::box({-half - 2 * radius, -2 * radius, bottom - 3}, {half + 2 * radius, 2 * radius, 0});
  Facets out{"groove", *booleanOf(block, tool, BooleanKind::kDifference), nullptr};
  out.beyond = [=](const Vec3& p) {
    const Vec3 on(std::clamp(p.x(), -half, half), 0.0, axis_z);
    const double free = (p - on).norm() - radius;  // > 0: in the material
    const bool wall = p.z() < -1e-5 && free < 0.5 * radius;
    return wall ? free : 0.0;  // the top and the outer faces are flat
  };
  return out;
}

TEST(ChordEstimate, GroovesWithBallEnds) {
  for (int form = 0; form < 4; ++form) {
    for (const double chord : kChords) {
      for (const double above : {0.0, 1.0})
        expectRight(report(groove(3.0, above, 30.0, chord, form),
                           fmt::format("form {} chord {} axis {}", form, chord, above)),
                    true);
    }
  }
}

Comparison against(const TriMesh& part, const TriMesh& nominal, double gouge, double excess) {
  Progress progress;
  CompareOptions options;
  options.gouge_mm = gouge;
  options.excess_mm = excess;
  options.resolution_mm = 0.25;
  Result<Comparison> c = compareToNominal(part, nominal, options, progress);
  EXPECT_TRUE(c.ok());
  return std::move(c).value();
}

/// What is decided keeps to its bound.
void expectBeyondBounds(const Comparison& c, const std::string& text) {
  for (const DeviationPatch& p : c.patches) {
    const double allowed = p.kind == DeviationKind::kGouge ? c.gouge_tolerance_mm : c.excess_tolerance_mm;
    EXPECT_GT(p.depth_mm - p.bound_mm, allowed) << text;
  }
}

/// Of facets in the order of constructive and boundary modellers, cut by others or not.
/// A right part against a coarse nominal: no error, also of tolerances smaller than the chords. One that is
/// wrong by more than the chords leave open: an error.
void expectNeitherFeignedNorHidden(const TriMesh& right, const TriMesh& wrong, double off,
                                   const Facets& nominal, const std::string& text) {
  for (const double tolerance : {0.003, 0.02}) {
    const Comparison c = against(right, nominal.mesh, tolerance, tolerance);
    EXPECT_TRUE(c.patches.empty()) << text << " tolerance " << tolerance << ": "
                                   << (c.patches.empty() ? 0.0 : c.patches[0].depth_mm);
    for (const DeviationPatch& p : c.patches)
      fmt::print("{}: {:.4f} within {:.4f} at {:.3f} {:.3f} {:.3f}\n", text, p.depth_mm, p.bound_mm,
                 p.where.x(), p.where.y(), p.where.z());
  }
  const Comparison c = against(wrong, nominal.mesh, 0.02, 0.02);
  EXPECT_FALSE(c.patches.empty()) << text << " off by " << off;
  expectBeyondBounds(c, text);
}

TEST(ChordEstimate, CoarseNominalsOfPinsAndBallsNeitherFeignNorHideErrors) {
  const double fine = 3e-4;
  for (const double chord : {0.005, 0.02, 0.05}) {
    const double off = 0.03 + 3.0 * chord;
    for (const Manner manner : {Manner::kFan, Manner::kStrips}) {
      const std::string text = fmt::format("{} chord {}", nameOf(manner), chord);
      expectNeitherFeignedNorHidden(pin(3.0, 2.0, 12.0, fine, Manner::kFan).mesh,
                                    pin(3.0 + off, 2.0, 12.0, fine, Manner::kFan).mesh, off,
                                    pin(3.0, 2.0, 12.0, chord, manner), "pin " + text);
      const auto ball = [&](double r, double height, Manner m) {
        return sphere(r, fragmentsFor(r, height) / 4 * 4, m);
      };
      expectNeitherFeignedNorHidden(ball(4.0, fine, Manner::kStrips).mesh,
                                    ball(4.0 + off, fine, Manner::kStrips).mesh, off,
                                    ball(4.0, chord, manner), "ball " + text);
    }
  }
}

TEST(ChordEstimate, CoarseNominalsOfGroovesNeitherFeignNorHideErrors) {
  for (const double axis : {0.0, 1.0}) {
    const TriMesh right = groove(3.0, axis, 30.0, 3e-4, 0).mesh;
    for (const double chord : {0.005, 0.02, 0.05}) {
      const double off = 0.03 + 3.0 * chord;
      const TriMesh wrong = groove(3.0 + off, axis, 30.0, 3e-4, 0).mesh;
      for (const int form : {0, 1, 3})  // the poles of balls without order are misread
        expectNeitherFeignedNorHidden(right, wrong, off, groove(3.0, axis, 30.0, chord, form),
                                      fmt::format("groove {} axis {} chord {}", form, axis, chord));
    }
  }
}

TEST(ChordEstimate, PolygonsThatMayBeMeantLeaveUndecidedWhatTheirRoundsExplain) {
  for (const int n : {8, 10, 12}) {
    const double radius = 3.2, chord = radius * (1.0 - std::cos(kPi / n));
    const TriMesh nominal = cylinder(radius, 8.0, n, Manner::kFan).mesh;
    EXPECT_TRUE(against(nominal, nominal, 0.02, 0.05).pass()) << n;
    const Comparison round = against(cylinder(radius, 8.0, 400, Manner::kFan).mesh, nominal, 0.02, 0.05);
    EXPECT_TRUE(round.patches.empty()) << n;
    EXPECT_NEAR(round.nominal_chord_mm, chord, 0.05 * chord) << n;
    const Comparison small =
        against(cylinder(radius - 2.0 * chord, 8.0, 400, Manner::kFan).mesh, nominal, 0.02, 0.05);
    EXPECT_FALSE(small.patches.empty()) << n;
  }
  // A hexagon is one: errors of its flats are decided.
  const TriMesh hexagon = cylinder(3.0, 8.0, 6, Manner::kFan).mesh;
  const Comparison c = against(cylinder(2.95, 8.0, 6, Manner::kFan).mesh, hexagon, 0.02, 0.05);
  ASSERT_FALSE(c.patches.empty());
  EXPECT_EQ(c.nominal_chord_mm, 0.0);
  EXPECT_EQ(c.patches[0].chord_mm, 0.0);
}

}  // namespace
}  // namespace proveout

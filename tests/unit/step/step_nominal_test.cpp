// A CAD model as nominal: deviations are those from its faces, whatever its facets are.
#include <gtest/gtest.h>

#include "app/session/nominal/nominal_mesh.h"
#include "io/step/step_file.h"
#include "removal/compare/compare.h"
#include "tests/unit/io/temp_folder.h"
#include "tests/unit/step/step_parts.h"

namespace proveout::test {
namespace {

/// How far the facets of a machined part lie off it, mm.
constexpr double kMachinedChord = 2e-3;

class StepNominal : public testing::Test {
 protected:
  NominalSpec nominalOf(const TopoDS_Shape& shape, const std::string& name) const {
    writeStep(folder_.path(name), {{"part", shape}});
    NominalSpec spec;
    spec.mesh.path = folder_.path(name);
    return spec;
  }
  /// A machined part as a mesh so fine that its facets do not count.
  TriMesh machined(const TopoDS_Shape& shape) const {
    const NominalSpec spec = nominalOf(shape, "machined.step");
    StepLoadOptions options;
    options.chord_mm = options.free_chord_mm = kMachinedChord;
    const Result<StepBody> body = loadStep(spec.mesh.path, options);
    EXPECT_TRUE(body) << body.error().message;
    const Result<PreparedMesh> solid = prepareNominal(body->mesh, "machined");
    EXPECT_TRUE(solid) << solid.error().message;
    return solid ? solid->mesh : TriMesh();
  }
  Comparison compared(const TriMesh& part, const NominalSpec& spec) const {
    const Result<PreparedMesh> nominal = loadNominal(spec);
    EXPECT_TRUE(nominal) << nominal.error().message;
    CompareOptions options;
    options.gouge_mm = spec.gouge_mm;
    options.excess_mm = spec.excess_mm;
    options.resolution_mm = 0.5;
    options.nominal_faces = nominal->faces;
    Progress progress;
    Result<Comparison> result = compareToNominal(part, nominal->mesh, options, progress);
    EXPECT_TRUE(result);
    return result ? std::move(*result) : Comparison();
  }
  io_test::TempFolder folder_;
};

TEST_F(StepNominal, ChordsDoNotMatter) {
  const NominalSpec spec = nominalOf(plate(), "nominal.step");
  const Comparison same = compared(machined(plate()), spec);
  EXPECT_TRUE(same.pass());
  EXPECT_LT(same.max_gouge_mm, 1.5 * kMachinedChord);
  EXPECT_LT(same.max_excess_mm, 1.5 * kMachinedChord);
  EXPECT_EQ(same.nominal_chord_mm, 0.0);
  PlateSizes sizes;
  sizes.blind_radius = 10.03;
  sizes.seat_radius = 7.94;
  const Comparison off = compared(machined(plate(sizes)), spec);
  EXPECT_NEAR(off.max_gouge_mm, 0.03, 1.5 * kMachinedChord);
  EXPECT_NEAR(off.max_excess_mm, 0.06, 1.5 * kMachinedChord);
  ASSERT_EQ(off.patches.size(), 2u);
  EXPECT_TRUE(off.undecided.empty());
}

const FaceFit& fitOf(const Comparison& comparison, SurfaceKind kind, double radius) {
  for (const FaceFit& fit : comparison.face_fits) {
    const CadFace& face = comparison.nominal_faces->faces[fit.face];
    if (face.kind == kind && std::abs(face.radius - radius) < 1e-9) return fit;
  }
  throw std::runtime_error("no such face");
}

TEST_F(StepNominal, FacesAreFittedByLeastSquares) {
  PlateSizes sizes;
  sizes.blind_radius = 10.03;
  sizes.seat_radius = 7.94;
  sizes.blind_x = 60.04;
  const NominalSpec spec = nominalOf(plate(), "nominal.step");
  const Comparison off = compared(machined(plate(sizes)), spec);
  const FaceFit& blind = fitOf(off, SurfaceKind::kCylinder, 10.0);
  EXPECT_NEAR(blind.fitted.radius, 10.03, 1.5 * kMachinedChord);
  EXPECT_TRUE(blind.placed);
  EXPECT_LT((blind.shift(off.nominal_faces->faces[blind.face]) - Vec3(0.04, 0, 0)).norm(),
            0.5 * kMachinedChord);
  EXPECT_NEAR(fitOf(off, SurfaceKind::kSphere, 8.0).fitted.radius, 7.94, 1.5 * kMachinedChord);
  const FaceFit& through = fitOf(off, SurfaceKind::kCylinder, 4.0);
  EXPECT_NEAR(through.fitted.radius, 4.0, 1.5 * kMachinedChord);
  EXPECT_LT(through.shift(off.nominal_faces->faces[through.face]).norm() + through.form_mm,
            3.0 * kMachinedChord);
  EXPECT_EQ(through.missed, 0u);
}

TEST_F(StepNominal, LiesWhereTheJobPutsIt) {
  NominalSpec spec = nominalOf(turnedPart(), "nominal.step");
  TriMesh part = machined(turnedPart());
  spec.placement.rotate_deg = Vec3(90, 0, 30);
  spec.placement.move = Vec3(10, -20, 5);
  placeMesh(spec.placement, part);
  const Comparison same = compared(part, spec);
  EXPECT_TRUE(same.pass());
  EXPECT_LT(std::max(same.max_gouge_mm, same.max_excess_mm), 1.5 * kMachinedChord);
}

TEST_F(StepNominal, FreeFacesAreSureToATenthOfTheTolerance) {
  NominalSpec spec = nominalOf(freeForm(), "nominal.step");
  spec.gouge_mm = spec.excess_mm = 0.05;
  const Comparison same = compared(machined(freeForm()), spec);
  EXPECT_TRUE(same.pass());
  EXPECT_LE(same.max_gouge_mm, 0.005 + 1.5 * kMachinedChord);
  EXPECT_LE(same.max_excess_mm, 0.005 + 1.5 * kMachinedChord);
  EXPECT_DOUBLE_EQ(same.nominal_chord_mm, 0.005);
}

}  // namespace
}  // namespace proveout::test

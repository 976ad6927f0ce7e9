// CAD models that are brought onto a part: by their surface, and by datums.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/nominal/alignment.h"
#include "app/session/nominal/nominal_mesh.h"
#include "removal/compare/compare.h"
#include "removal/compare/fit/fit.h"
#include "tests/unit/io/temp_folder.h"
#include "tests/unit/step/feature_part.h"
#include "tests/unit/step/step_parts.h"

namespace proveout::test {
namespace {

using testing::HasSubstr;

class StepAlignment : public testing::Test {
 protected:
  StepAlignment() {
    writeStep(folder_.path("part.step"), {{"part", featurePart()}});
    spec_.mesh.path = folder_.path("part.step");
  }
  /// The model where the part is, and displaced.
  PreparedMesh loaded(const MeshPlacement& placement) const {
    NominalSpec spec = spec_;
    spec.placement = placement;
    Result<PreparedMesh> out = loadNominal(spec);
    EXPECT_TRUE(out) << out.error().message;
    return out ? std::move(*out) : PreparedMesh();
  }
  AlignOutcome aligned(PreparedMesh& nominal) const {
    const PreparedMesh part = loaded({});
    Progress progress;
    Result<AlignOutcome> out = alignNominal(spec_, {part.mesh}, nominal, progress);
    EXPECT_TRUE(out) << out.error().message;
    return out ? std::move(*out) : AlignOutcome();
  }
  /// Of the plate with features of every kind, 120 x 100 x 20: its top, the through hole of 8 at (15, 15) and
  /// the blind one of 10 at (40, 15).
  void wishDatums() {
    spec_.align.kind = AlignKind::kDatums;
    spec_.align.datums = {{55, 30, 20}, {19, 15, 10}, {45, 15, 14}};
  }
  io_test::TempFolder folder_;
  NominalSpec spec_;
  const MeshPlacement away_{1.0, {0.1, -0.08, 0.12}, {0.15, -0.2, 0.1}};
};

TEST_F(StepAlignment, AFitBringsMeshAndFacesBack) {
  spec_.align.kind = AlignKind::kFit;
  PreparedMesh nominal = loaded(away_);
  const AlignOutcome outcome = aligned(nominal);
  ASSERT_TRUE(outcome.alignment) << outcome.fault;
  EXPECT_LT(farthestMove(outcome.alignment->motion * away_.motion(), loaded({}).mesh), 1e-3);
  EXPECT_LT(turnOf(outcome.alignment->motion * away_.motion()), 1e-5);
  const PreparedMesh right = loaded({});
  ASSERT_EQ(nominal.faces->faces.size(), right.faces->faces.size());
  for (std::size_t k = 0; k < right.faces->faces.size(); ++k) {
    const CadFace &found = nominal.faces->faces[k], &wanted = right.faces->faces[k];
    EXPECT_LT(found.axis.cross(wanted.axis).norm(), 1e-5);
    if (wanted.kind == SurfaceKind::kPlane) {
      EXPECT_LT(std::abs(wanted.distance(found.origin)), 2e-3);
    }
  }
  Progress progress;
  CompareOptions options;
  options.nominal_faces = nominal.faces;
  const Result<Comparison> compared = compareToNominal(right.mesh, nominal.mesh, options, progress);
  ASSERT_TRUE(compared) << compared.error().message;
  EXPECT_TRUE(compared->pass());
  EXPECT_LT(compared->rms_mm, 1e-3);
}

TEST_F(StepAlignment, DatumsBringItBack) {
  wishDatums();
  PreparedMesh nominal = loaded(away_);
  const AlignOutcome outcome = aligned(nominal);
  ASSERT_TRUE(outcome.alignment) << outcome.fault;
  EXPECT_EQ(outcome.alignment->kind, AlignKind::kDatums);
  EXPECT_LT(farthestMove(outcome.alignment->motion * away_.motion(), loaded({}).mesh), 3e-3);
  EXPECT_LT(outcome.alignment->rms_mm, 2e-3);
}

/// The drawing has the through hole at X15 Y15: where the part lies off, x and y are those of the drawing,
/// and what is wrong about a hole stays with it.
TEST_F(StepAlignment, FeaturesHaveTheCoordinatesOfTheModel) {
  wishDatums();
  FeaturePartSizes made;
  made.drill_x = 110.05;
  writeStep(folder_.path("made.step"), {{"part", featurePart(made)}});
  NominalSpec of_part;
  of_part.mesh.path = folder_.path("made.step");
  of_part.placement = away_;
  const Result<PreparedMesh> part = loadNominal(of_part);
  ASSERT_TRUE(part) << part.error().message;
  PreparedMesh nominal = loaded({});
  Progress progress;
  const Result<AlignOutcome> outcome = alignNominal(spec_, {part->mesh}, nominal, progress);
  ASSERT_TRUE(outcome && outcome->alignment);
  Comparison out;
  measureAligned(nominal, *outcome->alignment, {part->mesh}, 0.5, out);
  const auto expectX = [&](double x, double y, double wanted) {
    std::size_t found = 0;
    for (const Feature& feature : out.features) {
      if ((feature.at - Vec3(x, y, 0)).head<2>().norm() > 1.0) continue;
      for (const Characteristic& c : feature.characteristics) {
        if (c.quantity != Quantity::kX) continue;
        ++found;
        EXPECT_NEAR(c.nominal, x, 1e-6) << feature.name;
        EXPECT_NEAR(c.measured.value_or(1e9), wanted, 5e-3) << feature.name;
      }
    }
    EXPECT_GE(found, 1u);
  };
  expectX(15, 15, 15.0);
  expectX(110, 15, 110.05);
}

TEST_F(StepAlignment, DatumsOnOtherFacesAreTold) {
  wishDatums();
  spec_.align.datums[1] = {55, 30, 20};
  PreparedMesh nominal = loaded(away_);
  const AlignOutcome outcome = aligned(nominal);
  EXPECT_FALSE(outcome.alignment);
  EXPECT_THAT(outcome.fault, HasSubstr("the second datum"));
  EXPECT_THAT(outcome.fault, HasSubstr("has to lie on the wall of a hole"));
}

}  // namespace
}  // namespace proveout::test

// Jobs with STEP files as nominal, blank and fixture, from the program to the verdict.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/session/nominal/nominal_mesh.h"
#include "app/session/run/job_defaults.h"
#include "app/session/session.h"
#include "io/mesh_io.h"
#include "tests/unit/io/temp_folder.h"
#include "tests/unit/step/step_parts.h"

namespace proveout::test {
namespace {

using testing::HasSubstr;

class StepJob : public testing::Test {
 protected:
  StepJob() {
    writeStep(folder_.path("part.step"), {{"part", pocketBlock()}});
    writeStep(folder_.path("blank.stp"), {{"part", pocketBlock()}, {"blank", block()}});
  }
  std::optional<Job> job(const std::string& stock, const std::string& nominal) {
    JobNames names = jobNames();
    names.programs_in_memory = true;
    const std::string text = fmt::format(
        "schema = \"proveout.job/1\"\ncontrol = \"nct\"\nprogram = \"part.nc\"\n[stock]\nshape = "
        "\"mesh\"\n{}\n"
        "[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 10\n[[tool]]\nnumber = 2\ntype = \"flat\"\n"
        "diameter = 6\nflute_length = 20\n[nominal]\n{}\n{}\n[simulation]\nresolution = 0.5\n",
        stock, nominal, extra_);
    return parseJob(text, folder_.path("job.toml"), folder_.path(), names, diagnostics_);
  }
  /// The pocket is cut with a circle of that radius about its middle.
  Result<RunResult> run(double circle, bool drills = true) {
    const std::optional<Job> read =
        job("file = \"blank.stp\"\nbody = \"blank\"", fmt::format("mesh = \"{}\"", nominal_));
    if (!read) return inputError(diagnostics_.all().front().message);
    const MemoryProgramSource program(
        "part.nc",
        fmt::format("G21 G90 T1 M6\nS1000 M3 F500\nG0 X20 Y20 Z15\nG1 Z6\nN5 X{0}\nN6 G2 I-{1}\nG1 X20\n"
                    "G0 Z30\nT2 M6\nG0 X45 Y20\nZ15\n{2}G0 Z30\nM30\n",
                    20.0 + circle, circle, drills ? "G1 Z-1\n" : ""));
    Progress progress;
    return runJob(*read, {&program}, progress);
  }
  static std::string featureOf(const RunResult& result, FindingKind kind) {
    for (const Finding& finding : result.findings)
      if (finding.kind == kind) return finding.feature;
    return "";
  }
  std::string firstError() const {
    for (const Diagnostic& d : diagnostics_.all())
      if (d.severity == Severity::kError) return d.message;
    return "";
  }
  io_test::TempFolder folder_;
  Diagnostics diagnostics_;
  /// From here on the nominal is the same part as an STL file.
  void takeFacets() {
    NominalSpec spec;
    spec.mesh.path = folder_.path("part.step");
    const Result<PreparedMesh> model = loadNominal(spec);
    ASSERT_TRUE(model);
    ASSERT_TRUE(writeMesh(model->mesh, folder_.path("part.stl"), MeshFormat::kStlBinary));
    nominal_ = "part.stl";
  }
  std::string nominal_ = "part.step";
  std::string extra_;  ///< behind [nominal]
};

/// parts/measured_plate, with a D offset.
Result<RunResult> runSample(double radius_offset, Progress& progress) {
  Diagnostics diagnostics;
  JobNames names = jobNames();
  std::optional<Job> sample =
      loadJob(PROVEOUT_SOURCE_DIR "/parts/measured_plate/measured.toml", names, diagnostics);
  if (!sample) return inputError(diagnostics.all().front().message);
  sample->settings.radius_offsets[1] = {radius_offset, 0.0};
  return runJob(*sample, progress);
}

TEST(MeasuredPlate, HasTheDimensionsOfItsModel) {
  Progress progress;
  const Result<RunResult> result = runSample(4.0, progress);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->findings.empty()) << result->findings.front().message;
  ASSERT_TRUE(result->comparison);
  EXPECT_EQ(result->comparison->features.size(), 10u);
  for (const Feature& feature : result->comparison->features)
    for (const Characteristic& c : feature.characteristics)
      EXPECT_NEAR(c.measured.value_or(1e9), c.nominal, 1e-3)
          << feature.name << " " << quantityName(c.quantity);
  ASSERT_EQ(result->part_features.size(), 2u);
  EXPECT_NEAR(result->part_features[0].measured.value_or(0.0), 4.0, 1e-6);
  EXPECT_NEAR(result->part_features[1].measured.value_or(0.0), 5.0, 1e-3);
}

TEST(MeasuredPlate, AWrongOffsetFailsWidthAndLengthOfThePocketAlone) {
  Progress progress;
  const Result<RunResult> result = runSample(4.03, progress);
  ASSERT_TRUE(result) << result.error().message;
  int characteristics = 0;
  for (const Finding& finding : result->findings) {
    if (finding.kind != FindingKind::kCharacteristic) continue;
    ++characteristics;
    EXPECT_THAT(finding.message, testing::HasSubstr("of the pocket of 24 x 40"));
  }
  EXPECT_EQ(characteristics, 2);
}

TEST_F(StepJob, TheRightProgramPasses) {
  const Result<RunResult> result = run(3.0);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_TRUE(result->comparison.has_value());
  EXPECT_TRUE(result->comparison->pass());
  EXPECT_LT(result->comparison->max_gouge_mm, 1e-4);
  EXPECT_LT(result->comparison->max_excess_mm, 1e-4);
  EXPECT_GE(result->comparison->features.size(), 7u);
  for (const Feature& feature : result->comparison->features)
    for (const Characteristic& c : feature.characteristics)
      EXPECT_NEAR(c.measured.value_or(1e9), c.nominal, 2e-4)
          << feature.name << " " << quantityName(c.quantity);
  for (const FaceFit& fit : result->comparison->face_fits) {
    const CadFace& face = result->comparison->nominal_faces->faces[fit.face];
    EXPECT_EQ(fit.missed, 0u) << describe(face);
    EXPECT_LT(fit.form_mm + std::abs(fit.mean_mm) + fit.shift(face).norm(), 1e-4) << describe(face);
    if (face.kind == SurfaceKind::kCylinder) {
      EXPECT_NEAR(fit.fitted.radius, face.radius, 1e-4) << describe(face);
    }
  }
}

TEST_F(StepJob, AWrongRadiusIsToldToTheMicrometre) {
  const Result<RunResult> result = run(3.05);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->comparison->patches.size(), 1u);
  const DeviationPatch& patch = result->comparison->patches.front();
  EXPECT_EQ(patch.kind, DeviationKind::kGouge);
  EXPECT_NEAR(patch.depth_mm, 0.05, 1e-4);
  EXPECT_LT(patch.bound_mm, 1e-3);
  EXPECT_EQ(patch.chord_mm, 0.0);
  EXPECT_THAT(featureOf(*result, FindingKind::kGouge), HasSubstr("hole of diameter 16 at X20.000 Y20.000"));
}

TEST_F(StepJob, FacesMayHaveTolerancesOfTheirOwn) {
  // 0.05 too large: let pass on cylinders alone, in a region alone, and not elsewhere.
  for (const char* where : {"kind = \"cylinder\"", "min = [5, 5, 5]\nmax = [35, 35, 11]"}) {
    extra_ = fmt::format("[[nominal.tolerance]]\n{}\ngouge = 0.06\n", where);
    const Result<RunResult> result = run(3.05);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->comparison->pass()) << where;
  }
  extra_ = "[[nominal.tolerance]]\nkind = \"plane\"\ngouge = 0.06\n";
  EXPECT_FALSE(run(3.05)->comparison->pass());
  // And tighter than elsewhere.
  extra_ = "[[nominal.tolerance]]\nkind = \"cylinder\"\ngouge = 0.004\n";
  const Result<RunResult> tight = run(3.005);
  ASSERT_EQ(tight->comparison->patches.size(), 1u);
  EXPECT_EQ(tight->comparison->patches.front().allowed_mm, 0.004);
  extra_ = "[[nominal.tolerance]]\nface = \"nowhere\"\ngouge = 0.004\n";
  const Result<RunResult> wrong = run(3.0);
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("a face 'nowhere' that the file does not have"));
}

TEST_F(StepJob, CharacteristicsOfTheJobFailWithTheBlockToBlame) {
  extra_ =
      "[[characteristic]]\nname = \"seat\"\nat = [20, 20, 8]\nfeature = \"hole\"\nwhat = \"diameter\"\n"
      "tolerance = 0.004\n";
  const Result<RunResult> result = run(3.005);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->findings.size(), 1u);
  const Finding& finding = result->findings.front();
  EXPECT_EQ(finding.kind, FindingKind::kCharacteristic);
  EXPECT_THAT(finding.message, HasSubstr("+0.0100 off 16 (allowed -0.004 to +0.004, seat)"));
  EXPECT_NEAR(*finding.depth_mm, 0.01, 1e-4);
  ASSERT_TRUE(finding.source.has_value());
  EXPECT_EQ(finding.source->block, 6);
}

TEST_F(StepJob, FeaturesOfFacetsAreMeasuredWhereTheyAreAskedFor) {
  takeFacets();
  EXPECT_TRUE(run(3.0)->comparison->features.empty());
  for (const char* asked : {"features = true\n", "general_tolerance = \"m\"\n"}) {
    extra_ = asked;
    const Result<RunResult> result = run(3.0);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->comparison->faces_found);
    EXPECT_GE(result->comparison->features.size(), 7u);
    for (const Feature& feature : result->comparison->features)
      for (const Characteristic& c : feature.characteristics)
        EXPECT_NEAR(c.measured.value_or(1e9), c.nominal, 2e-3)
            << feature.name << " " << quantityName(c.quantity);
    for (const Finding& finding : result->findings) EXPECT_NE(finding.kind, FindingKind::kCharacteristic);
  }
}

TEST_F(StepJob, CharacteristicsOfFacetsFailWithTheBlockToBlame) {
  takeFacets();
  extra_ =
      "[[characteristic]]\nname = \"seat\"\nat = [20, 20, 8]\nfeature = \"hole\"\nwhat = \"diameter\"\n"
      "tolerance = 0.04\n";
  const Result<RunResult> result = run(3.1);
  ASSERT_TRUE(result) << result.error().message;
  const Finding* found = nullptr;
  for (const Finding& finding : result->findings)
    if (finding.kind == FindingKind::kCharacteristic) found = &finding;
  ASSERT_NE(found, nullptr);
  EXPECT_THAT(found->message, HasSubstr("off 16 (allowed -0.04 to +0.04, seat)"));
  EXPECT_NEAR(found->depth_mm.value_or(0.0), 0.2, 2e-3);
  ASSERT_TRUE(found->source.has_value());
  EXPECT_EQ(found->source->block, 6);
  // Deviations name the feature, too.
  EXPECT_THAT(featureOf(*result, FindingKind::kGouge), HasSubstr("hole of diameter 16 at X20.000 Y20.000"));
}

TEST_F(StepJob, FacesOfFacetsHaveAKindButNoName) {
  takeFacets();
  extra_ = "[[nominal.tolerance]]\nkind = \"cylinder\"\ngouge = 0.2\n";
  EXPECT_TRUE(run(3.1)->comparison->pass());
  extra_ = "[[nominal.tolerance]]\nkind = \"plane\"\ngouge = 0.2\n";
  EXPECT_FALSE(run(3.1)->comparison->pass());
  for (const char* named : {"[[nominal.tolerance]]\nface = \"seat\"\ngouge = 0.2\n",
                            "[[characteristic]]\nface = \"seat\"\nwhat = \"diameter\"\ntolerance = 0.1\n"}) {
    extra_ = named;
    const Result<RunResult> refused = run(3.0);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("the faces of a mesh have no names"));
  }
}

TEST_F(StepJob, AMissingHoleIsToldAsOne) {
  const Result<RunResult> result = run(3.0, false);
  ASSERT_TRUE(result) << result.error().message;
  for (const Finding& finding : result->findings) {
    if (finding.kind != FindingKind::kExcess) continue;
    EXPECT_EQ(finding.feature, "through hole of diameter 6 at X45.000 Y20.000");
    EXPECT_THAT(finding.message,
                testing::StartsWith("the through hole of diameter 6 at X45.000 Y20.000 is missing"));
  }
  EXPECT_EQ(featureOf(*result, FindingKind::kExcess), "through hole of diameter 6 at X45.000 Y20.000");
}

TEST_F(StepJob, RefusesWhatTheFileSaysItself) {
  EXPECT_FALSE(job("file = \"blank.stp\"\nbody = 2\nunit = \"inch\"", "mesh = \"part.step\""));
  EXPECT_THAT(firstError(), HasSubstr("a STEP file states its unit itself"));
}

TEST_F(StepJob, BodiesAreOfStepFilesOnly) {
  std::ofstream(folder_.path("blank.stl")) << "solid\nendsolid\n";
  EXPECT_FALSE(job("file = \"blank.stl\"\nbody = \"blank\"", "mesh = \"part.step\""));
  EXPECT_THAT(firstError(), HasSubstr("`body` names a body of a STEP file"));
}

}  // namespace
}  // namespace proveout::test

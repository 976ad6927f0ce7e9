// Features of CAD models: what they are called, what they measure, and that an error shows in its own row
// alone.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "app/session/findings/feature_table.h"
#include "app/session/nominal/nominal_mesh.h"
#include "core/mesh/signed_distance.h"
#include "io/mesh_io.h"
#include "removal/compare/compare.h"
#include "tests/unit/io/temp_folder.h"
#include "tests/unit/step/feature_part.h"
#include "tests/unit/step/step_parts.h"

namespace proveout::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A CAD model as a machined part that is known exactly: by the face of its nearest facet.
class ModelPart : public ExactPart {
 public:
  explicit ModelPart(const PreparedMesh& model)
      : faces_(model.faces), surface_(toSurface(model.mesh)), distance_(surface_, 0.25) {}
  Sample at(const Vec3& p, double) const override {
    const SurfaceDistance d = distance_.at(p);
    const CadFace* face = faces_->exactAt(d.triangle);
    Sample out;
    out.value = d.distance;
    out.normal = d.gradient.cast<double>();
    constexpr double kNear = 0.1;  // beside the chord the face itself is asked
    if (face != nullptr && std::abs(d.distance) < kNear) {
      out.value = face->distance(p);
      out.normal = face->normalAt(p);
    }
    return out;
  }
  double accuracy() const override { return 1e-6; }

 private:
  std::shared_ptr<const CadFaces> faces_;
  SurfaceMesh surface_;
  SignedDistance distance_;
};

class StepFeatures : public testing::Test {
 protected:
  PreparedMesh model(const TopoDS_Shape& shape, const std::string& name) const {
    writeStep(folder_.path(name), {{"part", shape}});
    NominalSpec spec;
    spec.mesh.path = folder_.path(name);
    Result<PreparedMesh> out = loadNominal(spec);
    EXPECT_TRUE(out) << (out ? "" : out.error().message);
    return out ? std::move(*out) : PreparedMesh();
  }
  static Comparison compared(const PreparedMesh& part, const PreparedMesh& nominal) {
    CompareOptions options;
    options.gouge_mm = options.excess_mm = 0.02;
    options.resolution_mm = 1.0;
    options.nominal_faces = nominal.faces;
    options.part = std::make_shared<ModelPart>(part);
    Progress progress;
    Result<Comparison> result = compareToNominal(part.mesh, nominal.mesh, options, progress);
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? std::move(*result) : Comparison();
  }
  /// The same part as a binary STL file.
  PreparedMesh facetsOf(const PreparedMesh& model, const std::string& name) const {
    EXPECT_TRUE(writeMesh(model.mesh, folder_.path(name), MeshFormat::kStlBinary));
    NominalSpec spec;
    spec.mesh.path = folder_.path(name);
    Result<PreparedMesh> out = loadNominal(spec);
    EXPECT_TRUE(out) << (out ? "" : out.error().message);
    return out ? std::move(*out) : PreparedMesh();
  }
  /// `part`: null: the machined mesh is all that is known.
  static Comparison comparedToFacets(const PreparedMesh& machined, const PreparedMesh& nominal,
                                     std::shared_ptr<const ExactPart> part) {
    CompareOptions options;
    options.gouge_mm = options.excess_mm = 0.02;
    options.resolution_mm = 1.0;
    options.find_features = true;
    options.part = std::move(part);
    Progress progress;
    Result<Comparison> result = compareToNominal(machined.mesh, nominal.mesh, options, progress);
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? std::move(*result) : Comparison();
  }
  static std::vector<ReportFeature> tableOf(const Comparison& comparison) {
    FeatureTolerances tolerances;
    tolerances.gouge_mm = tolerances.excess_mm = 0.02;
    return featureTable(comparison, tolerances);
  }
  /// "name: characteristic" of what failed.
  static std::vector<std::string> failed(const std::vector<ReportFeature>& table) {
    std::vector<std::string> out;
    for (const ReportFeature& feature : table) {
      if (feature.missing) out.push_back(feature.feature + ": missing");
      for (const ReportCharacteristic& c : feature.characteristics)
        if (c.verdict == "fail" && !feature.missing)
          out.push_back(
              fmt::format("{}: {}{}{}", feature.feature, c.part, c.part.empty() ? "" : " ", c.name));
    }
    return out;
  }
  static void print(const std::vector<ReportFeature>& table) {
    for (const ReportFeature& f : table) {
      fmt::print("{} {} {}{}\n", f.id, f.kind, f.feature, f.missing ? " MISSING" : "");
      for (const ReportCharacteristic& c : f.characteristics)
        fmt::print("    {} {} {:.6f} {} {} {}\n", c.part, c.name, c.nominal,
                   c.measured ? fmt::format("{:.6f}", *c.measured) : "-", c.upper.value_or(-1), c.verdict);
    }
  }
  io_test::TempFolder folder_;
};

TEST_F(StepFeatures, EveryDimensionOfThePlateIsThatOfItsModel) {
  const PreparedMesh nominal = model(featurePart(), "nominal.step");
  const std::vector<ReportFeature> table = tableOf(compared(nominal, nominal));
  EXPECT_TRUE(failed(table).empty());
  for (const ReportFeature& feature : table)
    for (const ReportCharacteristic& c : feature.characteristics)
      EXPECT_NEAR(c.measured.value_or(1e9), c.nominal, 2e-3) << feature.feature << " " << c.name;
}

TEST_F(StepFeatures, EveryDimensionOfTheShaftIsThatOfItsModel) {
  const PreparedMesh nominal = model(shaft(), "nominal.step");
  const std::vector<ReportFeature> table = tableOf(compared(nominal, nominal));
  EXPECT_TRUE(failed(table).empty());
  for (const ReportFeature& feature : table)
    for (const ReportCharacteristic& c : feature.characteristics)
      EXPECT_NEAR(c.measured.value_or(1e9), c.nominal, 2e-3) << feature.feature << " " << c.name;
}

/// Every row of the model's table is in that of its facets, with the same values but for the chord.
void expectSameRows(const std::vector<ReportFeature>& model, const std::vector<ReportFeature>& facets) {
  constexpr double kChord = 0.02, kDegrees = 0.05;
  EXPECT_EQ(facets.size(), model.size());
  for (const ReportFeature& feature : model) {
    const auto found = std::find_if(facets.begin(), facets.end(), [&](const ReportFeature& f) {
      return f.feature == feature.feature && (f.at - feature.at).norm() < 0.5;
    });
    ASSERT_NE(found, facets.end()) << feature.feature;
    const ReportFeature& other = *found;
    EXPECT_EQ(other.kind, feature.kind) << feature.feature;
    EXPECT_EQ(other.missing, feature.missing) << feature.feature;
    std::map<std::string, const ReportCharacteristic*> rows;
    for (const ReportCharacteristic& c : other.characteristics) rows.emplace(c.part + "/" + c.name, &c);
    EXPECT_EQ(other.characteristics.size(), feature.characteristics.size()) << feature.feature;
    for (const ReportCharacteristic& c : feature.characteristics) {
      const auto row = rows.find(c.part + "/" + c.name);
      ASSERT_NE(row, rows.end()) << feature.feature << " " << c.part << " " << c.name;
      const double near = c.unit == "deg" ? kDegrees : kChord;
      EXPECT_NEAR(row->second->nominal, c.nominal, near) << feature.feature << " " << c.part << " " << c.name;
      ASSERT_EQ(row->second->measured.has_value(), c.measured.has_value())
          << feature.feature << " " << c.name;
      if (c.measured) {
        EXPECT_NEAR(*row->second->measured, *c.measured, near)
            << feature.feature << " " << c.part << " " << c.name;
      }
    }
  }
}

/// Parts with some errors, so that what is measured is not what is nominal.
FeaturePartSizes wrongPlate() {
  FeaturePartSizes sizes;
  sizes.through_d = 8.05;
  sizes.blind_depth = 12.06;
  sizes.step_d = 12.1;
  sizes.pocket_w = 24.1;
  sizes.boss_x = 100.1;
  sizes.seat_r = 5.9;
  sizes.drill_d = 0;
  return sizes;
}
ShaftSizes wrongShaft() {
  ShaftSizes sizes;
  sizes.d1 = 30.05;
  sizes.bore_depth = 18.2;
  sizes.groove_r = 2.1;
  return sizes;
}

TEST_F(StepFeatures, FacetsOfThePlateHaveTheSameRows) {
  const PreparedMesh nominal = model(featurePart(), "nominal.step");
  const PreparedMesh part = model(featurePart(wrongPlate()), "part.step");
  const Comparison exact = compared(part, nominal);
  const Comparison facets =
      comparedToFacets(part, facetsOf(nominal, "nominal.stl"), std::make_shared<ModelPart>(part));
  EXPECT_FALSE(exact.faces_found);
  EXPECT_TRUE(facets.faces_found);
  expectSameRows(tableOf(exact), tableOf(facets));
  EXPECT_EQ(failed(tableOf(facets)).size(), failed(tableOf(exact)).size());
}

TEST_F(StepFeatures, FacetsOfTheShaftHaveTheSameRows) {
  const PreparedMesh nominal = model(shaft(), "nominal.step");
  const PreparedMesh part = model(shaft(wrongShaft()), "part.step");
  const Comparison facets =
      comparedToFacets(part, facetsOf(nominal, "nominal.stl"), std::make_shared<ModelPart>(part));
  expectSameRows(tableOf(compared(part, nominal)), tableOf(facets));
}

/// Both as STL: the part is measured to the faces of its own facets.
TEST_F(StepFeatures, FacetsOfBothPartsHaveTheSameRows) {
  const PreparedMesh nominal = model(featurePart(), "nominal.step");
  const PreparedMesh part = model(featurePart(wrongPlate()), "part.step");
  const Comparison facets =
      comparedToFacets(facetsOf(part, "part.stl"), facetsOf(nominal, "nominal.stl"), nullptr);
  expectSameRows(tableOf(compared(part, nominal)), tableOf(facets));
}

/// Deviations are measured to the facets, whatever is found in them.
TEST_F(StepFeatures, FoundFacesLeaveTheVerdictAlone) {
  const PreparedMesh nominal = facetsOf(model(featurePart(), "nominal.step"), "nominal.stl");
  const PreparedMesh part = model(featurePart(wrongPlate()), "part.step");
  const auto exact = std::make_shared<ModelPart>(part);
  const Comparison with = comparedToFacets(part, nominal, exact);
  CompareOptions options;
  options.gouge_mm = options.excess_mm = 0.02;
  options.resolution_mm = 1.0;
  options.part = exact;
  Progress progress;
  const Result<Comparison> without = compareToNominal(part.mesh, nominal.mesh, options, progress);
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->faces_found);
  EXPECT_TRUE(without->features.empty());
  EXPECT_EQ(with.max_gouge_mm, without->max_gouge_mm);
  EXPECT_EQ(with.max_excess_mm, without->max_excess_mm);
  EXPECT_EQ(with.rms_mm, without->rms_mm);
  EXPECT_EQ(with.nominal_chord_mm, without->nominal_chord_mm);
  ASSERT_EQ(with.patches.size(), without->patches.size());
  for (std::size_t k = 0; k < with.patches.size(); ++k) {
    EXPECT_EQ(with.patches[k].depth_mm, without->patches[k].depth_mm);
    EXPECT_EQ(with.patches[k].bound_mm, without->patches[k].bound_mm);
    EXPECT_NE(with.patches[k].face, kNoFace);
  }
}

/// A planted error: what is changed, the feature whose rows fail, and one of these.
template <typename Sizes>
struct Planted {
  std::string name;
  std::function<void(Sizes&)> change;
  std::string feature, row;
};

/// All that fails is of the feature, and the row is among it.
void expectOnly(const std::vector<std::string>& failed, const std::string& feature, const std::string& row,
                const std::string& name) {
  EXPECT_THAT(failed, testing::Each(HasSubstr(feature))) << name;
  EXPECT_THAT(failed, Contains(testing::AllOf(HasSubstr(feature), HasSubstr(row)))) << name;
}

TEST_F(StepFeatures, ErrorsOfThePlateShowInTheirFeatureAlone) {
  using S = FeaturePartSizes;
  const std::vector<Planted<S>> planted = {
      {"through too large", [](S& s) { s.through_d = 8.05; }, "hole of diameter 8 ", "diameter"},
      {"through too small", [](S& s) { s.through_d = 7.94; }, "hole of diameter 8 ", "diameter"},
      {"through moved in x", [](S& s) { s.through_x = 15.03; }, "hole of diameter 8 ", ": x"},
      {"through moved far", [](S& s) { s.through_y = 16.2; }, "hole of diameter 8 ", ": position"},
      {"through missing", [](S& s) { s.through_d = 0; }, "hole of diameter 8 ", "missing"},
      {"through not deep enough", [](S& s) { s.through_floor = 0.5; }, "hole of diameter 8 ", ": depth"},
      {"through half as deep", [](S& s) { s.through_floor = 8; }, "hole of diameter 8 ", ": depth"},
      {"swapped drills", [](S& s) { s.through_d = 6; }, "hole of diameter 8 ", ": diameter"},
      {"blind too deep", [](S& s) { s.blind_depth = 12.06; }, "hole of diameter 10 ", ": depth"},
      {"blind much too deep", [](S& s) { s.blind_depth = 15; }, "hole of diameter 10 ", ": depth"},
      {"blind too flat", [](S& s) { s.blind_depth = 11.9; }, "hole of diameter 10 ", ": depth"},
      {"blind too wide", [](S& s) { s.blind_d = 10.5; }, "hole of diameter 10 ", ": diameter"},
      {"blind moved", [](S& s) { s.blind_y = 14.95; }, "hole of diameter 10 ", ": y"},
      {"blind missing", [](S& s) { s.blind_d = 0; }, "hole of diameter 10 ", "missing"},
      {"counterbore too deep", [](S& s) { s.step_depth = 6.1; }, "12/6.8", "step of 12 depth"},
      {"counterbore too wide", [](S& s) { s.step_d = 12.1; }, "12/6.8", "step of 12 diameter"},
      {"bore too wide", [](S& s) { s.bore_d = 7; }, "12/6.8", "step of 6.8 diameter"},
      {"bore off the counterbore", [](S& s) { s.bore_x = 65.05; }, "12/6.8", "step of 6.8 x"},
      {"counterbore missing", [](S& s) { s.step_d = 0; }, "12/6.8", "step of 12 diameter"},
      {"countersink too wide", [](S& s) { s.sink_d = 14.2; }, "hole of diameter 7 ",
       "countersink cone diameter"},
      {"countersink of 82", [](S& s) { s.sink_angle = 82; }, "hole of diameter 7 ", "countersink angle"},
      {"countersunk hole wide", [](S& s) { s.sink_hole_d = 7.1; }, "hole of diameter 7 ", ": diameter"},
      {"drilled too deep", [](S& s) { s.drill_depth = 10.2; }, "hole of diameter 6 ", ": depth"},
      {"drill of 140", [](S& s) { s.drill_tip = 140; }, "hole of diameter 6 ", "tip angle"},
      {"drill missing", [](S& s) { s.drill_d = 0; }, "hole of diameter 6 ", "missing"},
      {"pocket too deep", [](S& s) { s.pocket_depth = 5.05; }, "pocket", ": depth"},
      {"pocket much too flat", [](S& s) { s.pocket_depth = 3; }, "pocket", ": depth"},
      {"pocket too wide", [](S& s) { s.pocket_w = 24.1; }, "pocket", ": width"},
      {"pocket too long", [](S& s) { s.pocket_l = 36.2; }, "pocket", ": length"},
      {"pocket moved", [](S& s) { s.pocket_x = 30.05; }, "pocket", ": x"},
      {"larger cutter in the corners", [](S& s) { s.pocket_r = 5; }, "pocket", "radius"},
      {"slot too wide", [](S& s) { s.slot_w = 10.06; }, "slot of width 10", ": width"},
      {"slot too deep", [](S& s) { s.slot_depth = 4.1; }, "slot of width 10", ": depth"},
      {"slot too short", [](S& s) { s.slot_l = 29.8; }, "slot of width 10", "end at"},
      {"slot moved", [](S& s) { s.slot_y = 55.04; }, "slot of width 10", ": y"},
      {"window too narrow", [](S& s) { s.window_w = 7.9; }, "slot of width 8", ": width"},
      {"window moved", [](S& s) { s.window_x = 110.05; }, "slot of width 8", ": x"},
      {"boss too wide", [](S& s) { s.boss_d = 20.06; }, "boss", ": diameter"},
      {"boss too high", [](S& s) { s.boss_h = 6.1; }, "boss", ": height"},
      {"boss moved", [](S& s) { s.boss_x = 100.1; }, "boss", ": x"},
      {"boss missing", [](S& s) { s.boss_d = 0; }, "boss", "missing"},
      {"seat too small", [](S& s) { s.seat_r = 5.9; }, "sphere", ": radius"},
      {"seat too low", [](S& s) { s.seat_z = 19.95; }, "sphere", ": z"},
      {"incline of 31", [](S& s) { s.chamfer_angle = 31; }, "-0.5000", ": angle"},
      {"fillet of 5.2", [](S& s) { s.fillet_r = 5.2; }, "outer round of radius 5", ": radius"},
      {"side too long", [](S& s) { s.side_x = 120.05; }, "plane at X120", ": x"},
  };
  const PreparedMesh nominal = model(featurePart(), "nominal.step");
  for (const Planted<S>& error : planted) {
    S sizes;
    error.change(sizes);
    const PreparedMesh part = model(featurePart(sizes), "part.step");
    expectOnly(failed(tableOf(compared(part, nominal))), error.feature, error.row, error.name);
  }
}

TEST_F(StepFeatures, ErrorsOfTheShaftShowInTheirFeatureAlone) {
  using S = ShaftSizes;
  const std::vector<Planted<S>> planted = {
      {"wide part", [](S& s) { s.d1 = 30.05; }, "of diameter 30 ", ": diameter"},
      {"narrow part", [](S& s) { s.d2 = 19.9; }, "of diameter 20 ", ": diameter"},
      {"bore", [](S& s) { s.bore_d = 10.1; }, "hole of diameter 10", ": diameter"},
      {"bore depth", [](S& s) { s.bore_depth = 18.2; }, "hole of diameter 10", ": depth"},
      {"groove", [](S& s) { s.groove_r = 2.1; }, "inner round of radius 2", ": radius"},
      {"groove moved", [](S& s) { s.groove_z = 12.1; }, "inner round of radius 2", ": z"},
  };
  const PreparedMesh nominal = model(shaft(), "nominal.step");
  for (const Planted<S>& error : planted) {
    S sizes;
    error.change(sizes);
    const PreparedMesh part = model(shaft(sizes), "part.step");
    std::vector<std::string> all = failed(tableOf(compared(part, nominal)));
    EXPECT_THAT(all, Contains(testing::AllOf(HasSubstr(error.feature), HasSubstr(error.row)))) << error.name;
  }
}

}  // namespace
}  // namespace proveout::test

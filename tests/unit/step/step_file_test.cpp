// What is read of STEP files: bodies, units, names, colours, faces; and what is refused.
#include "io/step/step_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "io/atomic_file.h"
#include "io/mesh_io.h"
#include "removal/compare/nominal.h"
#include "tests/unit/io/temp_folder.h"
#include "tests/unit/step/step_parts.h"

namespace proveout::test {
namespace {

using testing::HasSubstr;

class StepFile : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_.path(name); }
  std::string written(const std::vector<NamedShape>& shapes, const char* unit = "MM") const {
    writeStep(at("part.step"), shapes, unit);
    return at("part.step");
  }
  std::string refusal(const std::string& path, const std::string& body = "") const {
    const Result<StepBody> read = loadStep(path, {.body = body});
    return read ? "" : read.error().message;
  }
  io_test::TempFolder folder_;
};

std::size_t countOf(const StepBody& body, SurfaceKind kind) {
  std::size_t count = 0;
  for (const CadFace& face : body.faces.faces) count += face.kind == kind;
  return count;
}
const CadFace& firstOf(const StepBody& body, SurfaceKind kind) {
  for (const CadFace& face : body.faces.faces)
    if (face.kind == kind) return face;
  throw std::runtime_error("no such face");
}

TEST_F(StepFile, ReadsFacesWithTheirKindsSizesAndColours) {
  const Result<StepBody> body = loadStep(written({{"plate", plate()}}));
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ(body->name, "plate");
  EXPECT_EQ(body->unit, "millimetre");
  EXPECT_EQ(countOf(*body, SurfaceKind::kPlane), 8u);
  EXPECT_EQ(countOf(*body, SurfaceKind::kCylinder), 2u);
  EXPECT_EQ(countOf(*body, SurfaceKind::kOther), 0u);
  const CadFace& cone = firstOf(*body, SurfaceKind::kCone);
  EXPECT_NEAR(cone.half_angle_rad, M_PI / 4, 1e-12);
  EXPECT_TRUE(cone.hollow);
  const CadFace& seat = firstOf(*body, SurfaceKind::kSphere);
  EXPECT_NEAR((seat.origin - Vec3(85, 30, 20)).norm() + std::abs(seat.radius - 8), 0.0, 1e-9);
  const CadFace& groove = firstOf(*body, SurfaceKind::kTorus);
  EXPECT_NEAR(std::abs(groove.radius - 9) + std::abs(groove.tube_radius - 3), 0.0, 1e-9);
  EXPECT_TRUE(groove.hollow);
  const std::array<float, 3> red = {1.0f, 0.0f, 0.0f};
  EXPECT_EQ(body->faces.faces[0].colour, red);
  EXPECT_FALSE(body->faces.faces[1].colour.has_value());
  // Every corner lies on the face of its triangle, every triangle looks out of the material.
  for (std::size_t t = 0; t < body->mesh.triangles.size(); ++t) {
    const CadFace* face = body->faces.exactAt(static_cast<std::uint32_t>(t));
    ASSERT_NE(face, nullptr);
    Vec3 p[3];
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] = body->mesh.positions[body->mesh.triangles[t][c]].cast<double>();
      EXPECT_NEAR(face->distance(p[c]), 0.0, 1e-5);
    }
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]), middle = (p[0] + p[1] + p[2]) / 3.0;
    if (normal.norm() > 1e-6) {
      EXPECT_GT(face->distance(middle + 0.1 * normal.normalized()), 0.0);
    }
  }
  const Result<PreparedMesh> solid = prepareNominal(body->mesh, "plate");
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_TRUE(solid->notes.empty());
}

TEST_F(StepFile, KnowsTheUnitOfTheFile) {
  const Result<StepBody> body = loadStep(written({{"plate", plate()}}, "INCH"));
  ASSERT_TRUE(body) << body.error().message;
  EXPECT_EQ(body->unit, "INCH");
  const Box3 bounds = meshBounds(body->mesh);  // the writer leaves the numbers as they are
  EXPECT_NEAR((bounds.max - 25.4 * Vec3(100, 60, 20)).norm() + bounds.min.norm(), 0.0, 1e-3);
  EXPECT_NEAR(firstOf(*body, SurfaceKind::kSphere).radius, 25.4 * 8.0, 1e-9);
}

TEST_F(StepFile, ChoosesOneOfSeveralBodies) {
  const std::string path = written({{"plate", plate()}, {"shaft", turnedPart()}});
  EXPECT_THAT(refusal(path), HasSubstr("has 2 bodies: choose one by its name or number, body = \"plate\"; "
                                       "there are 1 plate, 2 shaft"));
  EXPECT_THAT(refusal(path, "screw"), HasSubstr("has no body screw; there are 1 plate, 2 shaft"));
  EXPECT_THAT(refusal(path, "3"), HasSubstr("has no body 3"));
  for (const char* const name : {"shaft", "2"}) {
    const Result<StepBody> body = loadStep(path, {.body = name});
    ASSERT_TRUE(body) << body.error().message;
    EXPECT_EQ(body->name, "shaft");
    EXPECT_THAT(body->bodies, testing::ElementsAre("plate", "shaft"));
    EXPECT_EQ(countOf(*body, SurfaceKind::kCone), 1u);
  }
}

TEST_F(StepFile, PlacesTheBodiesOfAnAssembly) {
  writeAssembly(at("assembly.step"));
  EXPECT_THAT(refusal(at("assembly.step")), HasSubstr("there are 1 base, 2 pin, 3 pin"));
  EXPECT_THAT(refusal(at("assembly.step"), "pin"),
              HasSubstr("has 2 bodies named pin: choose one by its number"));
  const std::pair<const char*, Box3> bodies[] = {{"base", {Vec3(0, 0, 0), Vec3(30, 30, 5)}},
                                                 {"2", {Vec3(8, 8, 5), Vec3(12, 12, 15)}},
                                                 {"3", {Vec3(-2, -10, -2), Vec3(2, 0, 2)}}};
  for (const auto& [name, box] : bodies) {
    const Result<StepBody> body = loadStep(at("assembly.step"), {.body = name});
    ASSERT_TRUE(body) << body.error().message;
    const Box3 bounds = meshBounds(body->mesh);
    EXPECT_LT((bounds.min - box.min).norm() + (bounds.max - box.max).norm(), 0.03) << name;  // of chords
  }
  const Result<StepBody> turned = loadStep(at("assembly.step"), {.body = "3"});
  EXPECT_NEAR(std::abs(firstOf(*turned, SurfaceKind::kCylinder).axis.y()), 1.0, 1e-12);
}

TEST_F(StepFile, FacesHaveTheNamesOfTheFile) {
  const Result<std::string> whole = readWholeFile(written({{"block", block()}}), 1u << 24);
  ASSERT_TRUE(whole);
  std::string text = *whole;
  int number = 0;
  for (std::size_t i = text.find("ADVANCED_FACE(''"); i != std::string::npos;
       i = text.find("ADVANCED_FACE(''", i))
    text.replace(i, 16, "ADVANCED_FACE('F" + std::to_string(++number) + "'");
  std::ofstream(at("named.step")) << text;
  const Result<StepBody> body = loadStep(at("named.step"));
  ASSERT_TRUE(body) << body.error().message;
  std::vector<std::string> names;
  for (const CadFace& face : body->faces.faces) names.push_back(face.name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("F1", "F2", "F3", "F4", "F5", "F6"));
}

TEST_F(StepFile, FacetsOfFreeFacesAreAsFineAsAsked) {
  const std::string path = written({{"form", freeForm()}});
  const Result<StepBody> coarse = loadStep(path, {.body = {}, .free_chord_mm = 0.05}),
                         fine = loadStep(path, {.body = {}, .free_chord_mm = 0.002});
  ASSERT_TRUE(coarse && fine);
  EXPECT_GE(countOf(*fine, SurfaceKind::kOther), 1u);
  EXPECT_EQ(fine->faces.chord_mm, 0.002);
  EXPECT_GT(fine->mesh.triangles.size(), 4 * coarse->mesh.triangles.size());
}

TEST_F(StepFile, RefusesWhatIsNoSolid) {
  EXPECT_THAT(refusal(written({{"box", openBox()}})), HasSubstr("has no solid: its 5 faces leave openings"));
  EXPECT_THAT(refusal(at("none.step")), HasSubstr("no such file"));
  std::ofstream(at("empty.step")).flush();
  EXPECT_THAT(refusal(at("empty.step")), HasSubstr("is empty"));
  std::ofstream(at("text.step")) << "this is no STEP file\n";
  EXPECT_NE(refusal(at("text.step")), "");
  std::ofstream(at("bare.step")) << "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_NE(refusal(at("bare.step")), "");
}

// Whatever stands in the file, the reader answers, and this process lives.
TEST_F(StepFile, AnswersOnDamagedFiles) {
  const Result<std::string> whole = readWholeFile(written({{"plate", plate()}}), 1u << 24);
  ASSERT_TRUE(whole);
  for (std::size_t k = 1; k <= 12; ++k) {
    std::string damaged = whole->substr(0, whole->size() * k / 12);
    for (std::size_t i = 997 * k; i < damaged.size(); i += 4001) damaged[i] = "#(),'$*9"[(i + k) % 8];
    std::ofstream(at("damaged.step"), std::ios::trunc) << damaged;
    const Result<StepBody> body = loadStep(at("damaged.step"));
    if (!body) {
      EXPECT_THAT(body.error().message, HasSubstr("damaged.step: "));
    }
  }
}

TEST_F(StepFile, IsAMeshWhereAMeshIsAsked) {
  const Result<TriMesh> mesh = loadMesh(written({{"plate", plate()}}));
  ASSERT_TRUE(mesh) << mesh.error().message;
  const double holes =
      M_PI * (16 * 16 + 100 * 10) + M_PI / 3 * 4 * (64 + 32 + 16) + 2 * M_PI * 512 / 3 + M_PI * M_PI * 9 * 9;
  EXPECT_NEAR(meshVolume(*mesh), 120000 - holes, 8.0);
}

}  // namespace
}  // namespace proveout::test

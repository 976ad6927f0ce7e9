// [[characteristic]] and the general tolerances of [nominal].
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job_fixture.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class JobCharacteristics : public testing::Test {
 protected:
  static std::string with(const std::string& nominal, const std::string& tables) {
    return io_test::kSmallJob + "[nominal]\nmesh = \"bracket.stl\"\n" + nominal + tables;
  }
  io_test::JobFolder folder_;
};

TEST_F(JobCharacteristics, AreRead) {
  const auto job =
      folder_.load(with("general_tolerance = \"mK\"\n",
                        "[[characteristic]]\nname = \"seat\"\nfeature = \"hole\"\nat = [1, 2, 3]\n"
                        "what = \"diameter\"\nlower = 0.0\nupper = 0.018\nnominal = 12\n"
                        "[[characteristic]]\nface = \"A\"\npart = \"step of 12\"\nsize = 6.8\n"
                        "what = \"position\"\ntolerance = 0.1\n"));
  ASSERT_TRUE(job) << folder_.text();
  EXPECT_EQ(job->nominal->general.text(), "ISO 2768-mK");
  ASSERT_EQ(job->nominal->characteristics.size(), 2u);
  const CharacteristicRule &seat = job->nominal->characteristics[0],
                           &place = job->nominal->characteristics[1];
  EXPECT_EQ(seat.name, "seat");
  EXPECT_EQ(seat.kind, FeatureKind::kHole);
  EXPECT_EQ(seat.quantity, Quantity::kDiameter);
  EXPECT_EQ(*seat.at, Vec3(1, 2, 3));
  EXPECT_EQ(seat.lower, 0.0);
  EXPECT_EQ(seat.upper, 0.018);
  EXPECT_EQ(seat.nominal, 12.0);
  EXPECT_EQ(place.face, "A");
  EXPECT_EQ(place.part, "step of 12");
  EXPECT_EQ(place.size, 6.8);
  EXPECT_EQ(place.upper, 0.1);
}

TEST_F(JobCharacteristics, WrongOnesAreRefused) {
  const std::string begin = "[[characteristic]]\nwhat = \"diameter\"\n";
  const std::pair<std::string, std::string> wrong[] = {
      {with("", begin), "has `tolerance` (to both sides), or `lower` and `upper`"},
      {with("", begin + "tolerance = 0.1\nupper = 0.2\n"), "or `lower` and `upper`"},
      {with("", begin + "lower = 0.1\nupper = 0.05\n"), "`lower` is not above `upper`"},
      {with("", begin + "tolerance = -0.1\n"), "tolerance"},
      {with("", begin + "tolerance = 0.1\nfeature = \"bore\"\n"), "feature"},
      {with("", begin + "tolerance = 0.1\ncolour = 1\n"), "colour"},
      {with("", "[[characteristic]]\ntolerance = 0.1\n"), "what"},
      {with("", "[[characteristic]]\nwhat = \"girth\"\ntolerance = 0.1\n"), "girth"},
      {with("", "[[characteristic]]\nwhat = \"flatness\"\nlower = 0.1\nupper = 0.2\n"), "is a zone"},
      {with("", "[[characteristic]]\nwhat = \"position\"\nnominal = 1\ntolerance = 0.2\n"), "is 0"},
      {with("general_tolerance = \"q\"\n", ""), "a class of ISO 2768"},
      {with("features = false\n", begin + "tolerance = 0.1\n"), "leaves no characteristics"},
      {io_test::kSmallJob + begin + "tolerance = 0.1\n", "the job has no [nominal]"},
  };
  for (const auto& [text, message] : wrong) EXPECT_THAT(folder_.refusal(text), HasSubstr(message)) << text;
}

TEST_F(JobCharacteristics, OfThePartNeedNoNominal) {
  const auto job =
      folder_.load(io_test::kSmallJob +
                   "[[characteristic]]\nname = \"rib\"\nwhat = \"wall thickness\"\nleast = 1.5\n"
                   "[[characteristic]]\nwhat = \"roughness\"\nmost = 1.6\nz = [-1, 1]\nradius = [0, 20]\n");
  ASSERT_TRUE(job) << folder_.text();
  ASSERT_EQ(job->part_characteristics.size(), 2u);
  EXPECT_EQ(job->part_characteristics[0].quantity, Quantity::kThickness);
  EXPECT_EQ(job->part_characteristics[0].name, "rib");
  EXPECT_EQ(job->part_characteristics[0].min, 1.5);
  EXPECT_FALSE(job->part_characteristics[0].max || job->part_characteristics[0].region);
  EXPECT_EQ(job->part_characteristics[1].max, 1.6);
  ASSERT_TRUE(job->part_characteristics[1].region);
  EXPECT_TRUE(job->part_characteristics[1].region->contains({0, 19, 0.5}));
  EXPECT_FALSE(job->part_characteristics[1].region->contains({0, 21, 0.5}));
}

TEST_F(JobCharacteristics, WrongOnesOfThePartAreRefused) {
  const std::string begin = io_test::kSmallJob + "[[characteristic]]\nwhat = \"wall thickness\"\n";
  const std::pair<std::string, std::string> wrong[] = {
      {begin, "has `least` or `most`"},
      {begin + "least = 2\nmost = 1\n", "`least` is not above `most`"},
      {begin + "least = -1\n", "least"},
      {begin + "least = nan\n", "least"},
      {begin + "tolerance = 0.1\nleast = 1\n", "tolerance"},
      {begin + "feature = \"hole\"\nleast = 1\n", "feature"},
      {begin + "least = 1\nmin = [0, 0, 0]\n", "a region is given by min and max"},
  };
  for (const auto& [text, message] : wrong) {
    EXPECT_FALSE(folder_.load(text)) << text;
    EXPECT_THAT(folder_.text(), HasSubstr(message)) << text;
  }
}

}  // namespace
}  // namespace proveout

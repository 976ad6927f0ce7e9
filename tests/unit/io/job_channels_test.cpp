// Channels of a job file.
// Proves nct-1.2-lathe
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job_fixture.h"

namespace proveout {
namespace {

using io_test::kSmallJob;
using io_test::replacedOnce;
using ::testing::HasSubstr;

/// The small job with channels in place of its program.
std::string withChannels(const std::string& channels, const std::string& more = "") {
  return replacedOnce(kSmallJob, "program = \"bracket.nc\"\n", more) + channels;
}

const std::string kTwo =
    "[[channel]]\nnumber = 2\nprogram = \"right.nc\"\nsubprograms = [\"subs\"]\nstart = [1, 2, 3]\ntool = 7\n"
    "[channel.offsets.work]\nG55 = [7, 8, 9]\n[channel.parameters]\nN1339 = 0.5\nN1337.SEC = 1\n"
    "[[channel]]\nnumber = 1\ntype = \"mill\"\nprogram = \"bracket.nc\"\n";

class JobChannels : public testing::Test {
 protected:
  JobChannels() {
    folder.write("right.nc", "M30\n");
    folder.write("subs/O1.nc", "M99\n");
    folder.names.parameters["nct"] = {{"N1339", 0, 10, 0}, {"N1337.SEC", 0, 1, 0}, {"N1700", 0, 399, 0}};
  }
  io_test::JobFolder folder;
};

TEST_F(JobChannels, AreReadAndSorted) {
  const auto job = folder.load(withChannels("[offsets.work]\nG54 = [1, 2, 3]\nG55 = [4, 5, 6]\n" + kTwo, ""));
  ASSERT_TRUE(job.has_value()) << folder.text();
  ASSERT_EQ(job->channels.size(), 2u);
  const ChannelSpec &left = job->channels[0], &right = job->channels[1];
  EXPECT_EQ(left.settings.channel, 1);
  EXPECT_THAT(left.program, HasSubstr("bracket.nc"));
  EXPECT_EQ(left.settings.tool, 0);
  EXPECT_FALSE(left.start.has_value());
  EXPECT_EQ(left.settings.work_offsets[1], Vec3(4, 5, 6));
  EXPECT_TRUE(left.settings.parameters.empty());
  EXPECT_EQ(right.settings.channel, 2);
  EXPECT_THAT(right.program, HasSubstr("right.nc"));
  EXPECT_EQ(right.subprograms.size(), 1u);
  EXPECT_EQ(right.settings.tool, 7);
  EXPECT_EQ(*right.start, Vec3(1, 2, 3));
  EXPECT_EQ(right.settings.work_offsets[0], Vec3(1, 2, 3));
  EXPECT_EQ(right.settings.work_offsets[1], Vec3(7, 8, 9));
  EXPECT_EQ(right.settings.parameters.at("N1339"), 0.5);
  EXPECT_EQ(right.settings.parameters.at("N1337.SEC"), 1);
  EXPECT_THAT(job->program, HasSubstr("bracket.nc"));
  EXPECT_THAT(programNames(*job), testing::AllOf(HasSubstr("bracket.nc, "), HasSubstr("right.nc")));
  EXPECT_EQ(setupCount(*job), 1u);
  EXPECT_EQ(jobOfSetup(*job, 0).channels.size(), 2u);
}

TEST_F(JobChannels, OwnParametersGoBeforeThoseOfTheJob) {
  const std::string control = "[control]\nname = \"nct\"\n[control.nct]\nN1339 = 0.1\nN1700 = 5\n";
  const std::string job_text = replacedOnce(withChannels(kTwo, control), "control = \"nct\"\n", "");
  const auto job = folder.load(job_text);
  ASSERT_TRUE(job.has_value()) << folder.text();
  EXPECT_EQ(job->channels[0].settings.parameters.at("N1339"), 0.1);
  EXPECT_EQ(job->channels[1].settings.parameters.at("N1339"), 0.5);
  EXPECT_EQ(job->channels[1].settings.parameters.at("N1700"), 5);
}

TEST_F(JobChannels, LatheChannelsAreRefused) {
  EXPECT_THAT(
      folder.refusal(withChannels("[[channel]]\nnumber = 1\ntype = \"lathe\"\nprogram = \"bracket.nc\"\n")),
      HasSubstr("error[job-unsupported]: a lathe channel has a control of its own"));
}

TEST_F(JobChannels, WrongOnesAreRefused) {
  const auto refused = [&](const std::string& channels, const std::string& why) {
    EXPECT_THAT(folder.refusal(withChannels(channels)), HasSubstr(why)) << channels;
  };
  refused("[[channel]]\nprogram = \"bracket.nc\"\n", "number");
  refused("[[channel]]\nnumber = 9\nprogram = \"bracket.nc\"\n", "number");
  refused("[[channel]]\nnumber = 1\n", "program");
  refused("[[channel]]\nnumber = 1\nprogram = \"absent.nc\"\n", "absent.nc");
  refused("[[channel]]\nnumber = 1\nprogram = \"bracket.nc\"\nspeed = 1\n", "speed");
  refused("[[channel]]\nnumber = 1\nprogram = \"bracket.nc\"\n[channel.parameters]\nN99 = 1\n", "N99");
  refused(
      "[[channel]]\nnumber = 1\nprogram = \"bracket.nc\"\n[[channel]]\nnumber = 1\nprogram = \"right.nc\"\n",
      "two channels with the number 1");
  refused(kTwo + "[[setup]]\nprogram = \"bracket.nc\"\n", "channels or setups");
  EXPECT_THAT(folder.refusal(kSmallJob + kTwo), HasSubstr("program belongs to the channels"));
  EXPECT_THAT(folder.refusal(withChannels("", "channel = []\n")), HasSubstr("at least one table"));
}

}  // namespace
}  // namespace proveout

// What M codes do to axes, in a machine file: what is read, and what is refused with its key and line.
#include "io/job/machine_events.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/job/job_sections.h"
#include "job_fixture.h"

namespace proveout {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

/// Lines 1 to 10; events of the tests begin behind them.
const std::string kEventAxes =
    "[[axis]]\nname = \"V\"\nnumber = 4\nkind = \"linear\"\n"
    "[[axis]]\nname = \"C\"\nnumber = 5\n"
    "[[spindle]]\nnumber = 2\nsync_code = 71\n";

struct EventsRead {
  Job job;
  Diagnostics diagnostics;
  std::string error;
};

EventsRead readMachineText(const std::string& text) {
  const fs::path path = fs::temp_directory_path() / fmt::format("events-{}.toml", ::getpid());
  std::ofstream(path) << text;
  EventsRead out;
  loadMachine(path.string(), out.job, out.diagnostics);
  fs::remove(path);
  for (const Diagnostic& d : out.diagnostics.all()) {
    if (out.error.empty()) out.error = fmt::format("{} {}: {}", d.where.line, d.code, d.message);
  }
  return out;
}

/// What is said of an event with this code 41 at line 12 and more lines.
std::string eventErrorOf(const std::string& lines) {
  return readMachineText(kEventAxes + "[[event]]\ncode = 41\n" + lines + "\n").error;
}

TEST(MachineEvents, AreRead) {
  const EventsRead read =
      readMachineText("gantry = [[\"X\", \"U\"]]\n" + kEventAxes +
                      "[[axis]]\nname = \"U\"\nnumber = 6\nkind = \"linear\"\n"
                      "[[event]]\ncode = 41\ncouple = [[\"Y\", \"V\"]]\nopposite = [\"V\"]\n"
                      "park = [\"V\", \"Y\"]\n"
                      "[[event]]\ncode = 42\nexchange = [\"Y\", \"Z\"]\nreverse = [\"X\"]\n"
                      "[[event]]\ncode = 43\nhead = \"horizontal\"\ngauge = [1, 2, 3]\n"
                      "[[event]]\ncode = 44\nrelease = [\"park\", \"head\"]\n"
                      "[[event]]\ncode = 40\nrelease = true\n");
  ASSERT_EQ(read.error, "");
  const ControlSettings& s = read.job.settings;
  ASSERT_EQ(s.events.size(), 5u);
  EXPECT_EQ(s.events[0].code, 41);
  ASSERT_EQ(s.events[0].couple.size(), 1u);
  EXPECT_EQ(s.events[0].couple[0].first, "Y");
  EXPECT_EQ(s.events[0].couple[0].second, "V");
  EXPECT_EQ(s.events[0].opposite, std::vector<std::string>{"V"});
  EXPECT_EQ(s.events[0].park, (std::vector<std::string>{"V", "Y"}));
  ASSERT_TRUE(s.events[1].exchange);
  EXPECT_EQ(s.events[1].exchange->second, "Z");
  EXPECT_EQ(s.events[1].reverse, std::vector<std::string>{"X"});
  EXPECT_EQ(s.events[2].head, HeadPosition::kHorizontal);
  EXPECT_EQ(s.events[2].gauge, Vec3(1, 2, 3));
  EXPECT_EQ(s.events[3].release, (std::vector<AxisMode>{AxisMode::kPark, AxisMode::kHead}));
  EXPECT_EQ(s.events[4].release.size(), 5u);
  ASSERT_EQ(s.gantry.size(), 1u);
  EXPECT_EQ(s.gantry[0].second, "U");
}

TEST(MachineEvents, RefuseWhatCannotBe) {
  const std::pair<const char*, const char*> rows[] = {
      {"park = [\"Q\"]", "13 job-value: there is no axis 'Q': the machine has X, Y, Z, V, C"},
      {"park = [\"V\", \"V\"]", "13 job-value: axis V stands there twice"},
      {"couple = [[\"Y\", \"Y\"]]", "13 job-value: axis Y is paired with itself"},
      {"couple = [[\"Y\", \"C\"]]", "13 job-value: Y and C are a linear and a rotary axis"},
      {"couple = [[\"Y\", \"V\"], [\"Z\", \"V\"]]", "13 job-value: axis V has two masters"},
      {"couple = [[\"Y\", \"V\"], [\"V\", \"Y\"]]", "13 job-value: axis V follows itself in the end"},
      {"couple = [\"Y\", \"V\"]", "13 job-type: couple names axes in pairs: [\"Y\", \"V\"]"},
      {"couple = [[\"Y\", 3]]", "13 job-type: couple"},
      {"couple = [[\"Y\", \"V\"]]\nopposite = [\"Y\"]", "14 job-value: axis Y is no slave of this event"},
      {"exchange = [\"Y\", \"C\"]", "13 job-value: Y and C are a linear and a rotary axis"},
      {"exchange = [\"Y\", \"Z\", \"X\"]", "13 job-type: exchange names axes in pairs"},
      {"head = \"horizontal\"\nreverse = [\"X\"]",
       "13 job-value: head exchanges and reverses the axes itself"},
      {"head = \"lying\"", "13 job-value: head 'lying' is not known"},
      {"park = [\"V\"]\ngauge = [0, 0, 1]", "14 job-value: gauge is that of the horizontal head"},
      {"release = true", "13 job-value: no event switches on what this one releases"},
      {"release = false", "13 job-value: release = false does nothing"},
      {"release = [\"everything\"]", "13 job-value: release 'everything' is not known"},
      {"", "12 job-value: M41 does nothing: give couple"},
      {"park = [\"V\"]\nparks = 1", "14 job-unknown-key"},
      {"park = [\"V\"]\n[[event]]\ncode = 41\npark = [\"Y\"]",
       "15 job-value: M41 is the code of event 1 already"},
      {"park = [\"V\"]\n[[event]]\ncode = 71\npark = [\"Y\"]",
       "15 job-value: M71 is a code of spindle 2 already"},
      {"park = [\"V\"]\n[[event]]\npark = [\"Y\"]", "14 job-missing"},
      {"park = [\"V\"]\n[[event]]\ncode = 0\npark = [\"Y\"]", "15 job-range"},
  };
  for (const auto& [lines, error] : rows) EXPECT_THAT(eventErrorOf(lines), StartsWith(error)) << lines;
}

TEST(MachineEvents, DrivesOfOneAxisAreNoOthers) {
  const auto errorOfDrives = [](const std::string& keys, const std::string& events) {
    return readMachineText(keys + "\n" + kEventAxes + events).error;
  };
  EXPECT_EQ(errorOfDrives("gantry = [[\"Y\", \"V\"]]", ""), "");
  EXPECT_THAT(errorOfDrives("gantry = [[\"Y\", \"V\"]]", "[[event]]\ncode = 41\npark = [\"V\"]\n"),
              HasSubstr("axis V is the second drive of another one"));
  EXPECT_THAT(errorOfDrives("gantry = [[\"V\", \"Y\"]]", ""),
              StartsWith("1 job-value: programs move axis Y"));
  EXPECT_THAT(errorOfDrives("tandem = [[\"Y\", \"C\"]]", ""),
              StartsWith("1 job-value: Y and C are a linear"));
  EXPECT_THAT(errorOfDrives("tandem = [[\"Y\", \"V\"], [\"Z\", \"V\"]]", ""),
              StartsWith("1 job-value: axis V has two masters"));
  EXPECT_THAT(
      readMachineText("gantry = [[\"Y\", \"V\"]]\n[[axis]]\nname = \"V\"\nnumber = 4\nkind = \"linear\"\n"
                      "parallel = \"Y\"\n")
          .error,
      StartsWith("1 job-value: axis V is a drive of Y alone: it must carry nothing"));
}

TEST(MachineEvents, OfTheJobStandForThoseOfTheFile) {
  io_test::JobFolder folder;
  folder.write("machine.toml", kEventAxes + "[[event]]\ncode = 41\npark = [\"V\"]\n");
  const std::string job = io_test::kSmallJob + "[machine]\nfile = \"machine.toml\"\n";
  const auto plain = folder.load(job);
  ASSERT_TRUE(plain) << folder.text();
  ASSERT_EQ(plain->settings.events.size(), 1u);
  const auto own = folder.load(job + "[[machine.event]]\ncode = 51\npark = [\"Y\"]\n");
  ASSERT_TRUE(own) << folder.text();
  ASSERT_EQ(own->settings.events.size(), 1u);
  EXPECT_EQ(own->settings.events[0].code, 51);
}

}  // namespace
}  // namespace proveout

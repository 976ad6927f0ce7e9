// Several channels: what each does is what it does alone, and all of it comes in order of time.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "core/nc/registry/interpreter.h"

namespace proveout {
namespace {

std::string randomProgram(std::mt19937& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::string text = "F1200\n";
  for (int k = 0; k < 60; ++k) {
    switch (below(5)) {
      case 0:
        text += fmt::format("G0 X{} Y{}\n", below(100), below(100));
        break;
      case 1:
        text += fmt::format("G4 P0.{}\n", below(10));
        break;
      case 2:
        text += fmt::format("G91 G2 X10 I5 F{}\nG90\n", 500 + below(1000));
        break;
      default:
        text += fmt::format("G1 X{} Z{}\n", below(100), below(20));
        break;
    }
  }
  return text + "M30\n";
}

ControlSettings settingsOf(int channel, double acceleration) {
  ControlSettings settings;
  settings.channel = channel;
  settings.acceleration_mm_s2 = Vec3::Constant(acceleration);
  return settings;
}

struct Done {
  Toolpath path;
  InterpretSummary summary;
};

Done runTogether(const std::vector<std::string>& texts, double acceleration) {
  Done done;
  ToolpathBuilder sink(done.path);
  std::vector<std::unique_ptr<MemoryProgramSource>> sources;
  std::vector<ChannelProgram> programs;
  for (const std::string& text : texts) {
    const int number = static_cast<int>(programs.size()) + 1;
    sources.push_back(std::make_unique<MemoryProgramSource>(fmt::format("p{}.nc", number), text));
    programs.push_back({sources.back().get(), settingsOf(number, acceleration)});
  }
  done.summary = interpretChannels(ControlId::kNct, programs, sink);
  return done;
}

Done runAlone(const std::string& text, double acceleration) {
  Done done;
  ToolpathBuilder sink(done.path);
  const MemoryProgramSource source("p.nc", text);
  done.summary = interpret(ControlId::kNct, source, settingsOf(0, acceleration), sink);
  return done;
}

/// Start times of motions by adding up what each channel does before.
std::vector<double> startTimes(const Toolpath& path) {
  std::vector<double> starts, now(9, 0.0);
  std::size_t event = 0;
  const auto pass = [&](std::size_t before) {
    for (; event < path.events.size() && path.events[event].before <= before; ++event)
      now[path.events[event].event.channel] += path.events[event].event.time_s;
  };
  for (std::size_t i = 0; i < path.motions.size(); ++i) {
    pass(i);
    starts.push_back(now[path.motions[i].channel]);
    now[path.motions[i].channel] += path.motions[i].time_s;
  }
  return starts;
}

TEST(Channels, EachGoesItsWayAndStartsAreInOrder) {
  std::mt19937 random(7);
  for (const double acceleration : {0.0, 800.0}) {
    for (int round = 0; round < 12; ++round) {
      std::vector<std::string> texts;
      for (int k = 0; k < 2 + round % 3; ++k) texts.push_back(randomProgram(random));
      const Done together = runTogether(texts, acceleration);
      ASSERT_TRUE(together.summary.ok());
      const std::vector<double> starts = startTimes(together.path);
      for (std::size_t i = 1; i < starts.size(); ++i) EXPECT_GE(starts[i], starts[i - 1] - 1e-9);
      double end_s = 0.0;
      std::size_t motions = 0;
      for (std::size_t k = 0; k < texts.size(); ++k) {
        const Done alone = runAlone(texts[k], acceleration);
        end_s = std::max(end_s, alone.summary.cycle_s);
        std::size_t next = 0;
        for (const Motion& motion : together.path.motions) {
          if (motion.channel != k + 1) continue;
          ASSERT_LT(next, alone.path.motions.size());
          const Motion& own = alone.path.motions[next++];
          EXPECT_EQ(motion.from, own.from);
          EXPECT_EQ(motion.to, own.to);
          EXPECT_EQ(motion.time_s, own.time_s);
          EXPECT_EQ(motion.source.line, own.source.line);
        }
        EXPECT_EQ(next, alone.path.motions.size());
        motions += next;
      }
      EXPECT_EQ(together.summary.motions, motions);
      EXPECT_NEAR(together.summary.cycle_s, end_s, 1e-9);
    }
  }
}

TEST(Channels, WaitsWithAccelerationsLastUntilTheLastStands) {
  // 100 mm at 6000 mm/min with 1000 mm/s^2: v / a = 0.1 s up and down, 10 mm; 1 s + 0.1 s. 10 mm: 0.2 s.
  std::vector<std::string> texts{"G1 X10 F6000\nM500 P12\nX20\nM30\n", "G1 X100 F6000\nM500 P12\nX90\nM30\n"};
  Done done;
  ToolpathBuilder sink(done.path);
  std::vector<std::unique_ptr<MemoryProgramSource>> sources;
  std::vector<ChannelProgram> programs;
  for (int k = 0; k < 2; ++k) {
    sources.push_back(std::make_unique<MemoryProgramSource>("p.nc", texts[static_cast<std::size_t>(k)]));
    programs.push_back({sources.back().get(), settingsOf(k + 1, 1000.0)});
    programs.back().settings.start = Vec3::Zero();
    programs.back().settings.parameters = {{"N2201", 500}, {"N2202", 500}};
  }
  done.summary = interpretChannels(ControlId::kNct, programs, sink);
  ASSERT_TRUE(done.summary.ok());
  const std::vector<double> starts = startTimes(done.path);
  ASSERT_EQ(starts.size(), 4u);
  EXPECT_NEAR(starts[2], 1.1, 1e-9);
  EXPECT_NEAR(starts[3], 1.1, 1e-9);
  EXPECT_NEAR(done.summary.cycle_s, 1.3, 1e-9);
}

/// A step of a plan: a dwell, or a meeting of channels.
struct PlanStep {
  int tenths = 0;  ///< dwell, 0.1 s
  int code = 0;    ///< or a waiting code
  std::string whom;
};
using Plan = std::vector<std::vector<PlanStep>>;  ///< by channel

/// Meetings that fit together; with `spoil` two of one channel may change places.
Plan randomPlan(std::mt19937& random, bool spoil) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  Plan plan(2 + below(3));
  for (int meeting = 0; meeting < 8; ++meeting) {
    std::string whom;
    for (std::size_t k = 0; k < plan.size(); ++k) {
      if (below(3) > 0) whom += std::to_string(k + 1);
    }
    if (whom.size() < 2) continue;
    const int code = 500 + static_cast<int>(below(3));
    for (const char digit : whom) {
      auto& steps = plan[static_cast<std::size_t>(digit - '1')];
      steps.push_back({static_cast<int>(below(30)), 0, ""});
      steps.push_back({0, code, whom});
    }
  }
  if (spoil) {
    auto& steps = plan[below(plan.size())];
    if (steps.size() >= 4) std::swap(steps[1], steps[3]);
  }
  return plan;
}

/// When the last channel ends, s; below 0: they wait for each other.
double endOf(const Plan& plan) {
  std::vector<std::size_t> at(plan.size(), 0);
  std::vector<int> now(plan.size(), 0);
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t k = 0; k < plan.size(); ++k) {
      if (at[k] == plan[k].size()) continue;
      const PlanStep& step = plan[k][at[k]];
      if (step.code == 0) {
        now[k] += step.tenths;
        ++at[k];
        moved = true;
        continue;
      }
      bool all = true;
      int last = 0;
      for (const char digit : step.whom) {
        const auto other = static_cast<std::size_t>(digit - '1');
        const bool there = at[other] < plan[other].size() && plan[other][at[other]].code == step.code &&
                           plan[other][at[other]].whom == step.whom;
        all = all && there;
        last = std::max(last, now[other]);
      }
      if (!all) continue;
      for (const char digit : step.whom) {
        const auto other = static_cast<std::size_t>(digit - '1');
        now[other] = last;
        ++at[other];
      }
      moved = true;
    }
  }
  for (std::size_t k = 0; k < plan.size(); ++k) {
    if (at[k] < plan[k].size()) return -1.0;
  }
  return 0.1 * *std::max_element(now.begin(), now.end());
}

TEST(Channels, MeetingsAndDeadlocksAreThoseOfASlowReference) {
  std::mt19937 random(11);
  int stuck = 0;
  for (int round = 0; round < 300; ++round) {
    const Plan plan = randomPlan(random, round % 3 == 0);
    std::vector<std::unique_ptr<MemoryProgramSource>> sources;
    std::vector<ChannelProgram> programs;
    for (const auto& steps : plan) {
      std::string text;
      for (const PlanStep& step : steps) {
        text += step.code > 0 ? fmt::format("M{} P{}\n", step.code, step.whom)
                              : fmt::format("G4 P{}.{}\n", step.tenths / 10, step.tenths % 10);
      }
      const int number = static_cast<int>(programs.size()) + 1;
      sources.push_back(std::make_unique<MemoryProgramSource>("p.nc", text + "M30\n"));
      programs.push_back({sources.back().get(), settingsOf(number, 0.0)});
      programs.back().settings.parameters = {{"N2201", 500}, {"N2202", 599}};
    }
    Toolpath path;
    ToolpathBuilder sink(path);
    const InterpretSummary summary = interpretChannels(ControlId::kNct, programs, sink);
    const double end_s = endOf(plan);
    if (end_s >= 0.0) {
      EXPECT_TRUE(summary.ok()) << round;
      EXPECT_NEAR(summary.cycle_s, end_s, 1e-9) << round;
    } else {
      ++stuck;
      ASSERT_EQ(path.diagnostics.errorCount(), 1) << round;
      EXPECT_EQ(summary.end, ProgramEnd::kAlarm);
      EXPECT_EQ(path.diagnostics.all().back().code, "nct-deadlock");
    }
  }
  EXPECT_GT(stuck, 10);
  EXPECT_LT(stuck, 150);
}

TEST(Channels, NumbersAreChecked) {
  const MemoryProgramSource source("p.nc", "M30\n");
  const auto errorsOf = [&](const std::vector<int>& numbers) {
    std::vector<ChannelProgram> programs;
    for (const int number : numbers) programs.push_back({&source, settingsOf(number, 0.0)});
    Toolpath path;
    ToolpathBuilder sink(path);
    const InterpretSummary summary = interpretChannels(ControlId::kNct, programs, sink);
    EXPECT_EQ(summary.errors, path.diagnostics.errorCount());
    return summary.errors;
  };
  EXPECT_EQ(errorsOf({1, 2, 8}), 0);
  EXPECT_EQ(errorsOf({3}), 0);
  EXPECT_EQ(errorsOf({}), 1);
  EXPECT_EQ(errorsOf({0, 1}), 1);
  EXPECT_EQ(errorsOf({1, 9}), 1);
  EXPECT_EQ(errorsOf({2, 2}), 1);
}

TEST(Channels, ALoopThatNobodyEndsMeetsTheLimitOfBlocks) {
  const MemoryProgramSource endless("p.nc", "WHILE[1 EQ 1] DO1\nEND1\nM30\n"),
      other("q.nc", "G1 X5 F100\nM30\n");
  std::vector<ChannelProgram> programs{{&endless, settingsOf(1, 0.0)}, {&other, settingsOf(2, 0.0)}};
  for (ChannelProgram& program : programs) program.settings.block_limit = 100'000;
  Toolpath path;
  ToolpathBuilder sink(path);
  const InterpretSummary summary = interpretChannels(ControlId::kNct, programs, sink);
  EXPECT_EQ(summary.end, ProgramEnd::kBlockLimit);
  EXPECT_EQ(path.motions.size(), 1u);
}

TEST(Channels, FilesAreOpenInOneChannelAtATime) {
  const MemoryProgramSource first("p.nc", "FOPEN1 P11\nG4 P2\nFCLOS\nM30\n");
  const MemoryProgramSource second("q.nc", "G4 P1\nFOPEN1 P12\nFCLOS\nM30\n");
  const std::vector<ChannelProgram> programs{{&first, settingsOf(1, 0.0)}, {&second, settingsOf(2, 0.0)}};
  Toolpath path;
  ToolpathBuilder sink(path);
  MemoryOutput output;
  ControlHost host;
  host.output = &output;
  EXPECT_EQ(interpretChannels(ControlId::kNct, programs, sink, nullptr, host).errors, 1);
}

}  // namespace
}  // namespace proveout

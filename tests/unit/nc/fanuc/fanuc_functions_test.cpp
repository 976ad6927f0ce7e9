// M codes: stops, spindle, coolant, what the machine does by itself; ends.
#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;

IsoRun functionsMill(const std::string& text, const ControlSettings& settings = runAtZero()) {
  return {ControlId::kFanucMill, text, settings};
}

/// Names of what the path has between motions, in order: "stop M0", "coolant on".
Lines eventsOf(const IsoRun& run) {
  Lines all;
  for (const auto& [at, e] : run.path.events) {
    if (const auto* stop = e.as<event::Stop>()) all.push_back("stop " + stop->code);
    if (const auto* optional = e.as<event::OptionalStop>())
      all.push_back(optional->code + (optional->active ? " stops" : " goes on"));
    if (const auto* coolant = e.as<event::Coolant>())
      all.push_back(coolant->code + (coolant->on ? " on" : " off"));
    if (const auto* function = e.as<event::Function>()) all.push_back("function " + function->code);
  }
  return all;
}

// fan-14-M00 fan-14-M01
TEST(FanucFunctions, StopsAreTold) {
  EXPECT_EQ(eventsOf(functionsMill("O1\nM0\nM00\nM30\n")), (Lines{"stop M0", "stop M0"}));
  EXPECT_EQ(eventsOf(functionsMill("O1\nM1\nM30\n")), (Lines{"M1 goes on"}));
  ControlSettings settings = runAtZero();
  settings.optional_stop = true;
  EXPECT_EQ(eventsOf(functionsMill("O1\nM01\nM30\n", settings)), (Lines{"M1 stops"}));
}

// fan-14-coolant
TEST(FanucFunctions, CoolantIsTracked) {
  EXPECT_EQ(eventsOf(functionsMill("O1\nM8\nM9\nM7\nM9\nM30\n")),
            (Lines{"M8 on", "M9 off", "M7 on", "M9 off"}));
}

// fan-14-spindle
TEST(FanucFunctions, SpindleCodesAreInTheMotions) {
  const IsoRun run = functionsMill("O1\nS500 M3\nG1 X1. F100\nM4\nX2.\nM5\nM19\nG0 X3.\nM30\n");
  ASSERT_EQ(run.error(), "") << run.message();
  ASSERT_EQ(run.path.motions.size(), 3u);
  const auto speed = [&](std::size_t k) { return run.path.motions[k].spindle; };
  EXPECT_EQ(speed(0), 500);
  EXPECT_EQ(speed(1), -500);
  EXPECT_EQ(speed(2), 0);
}

// fan-14-clamp
TEST(FanucFunctions, WhatTheMachineDoesByItselfIsNoted) {
  const IsoRun run = functionsMill("O1\nM10\nM11\nM31\nM33\nM60\nM30\n");
  EXPECT_EQ(run.error(), "");
  EXPECT_EQ(eventsOf(run),
            (Lines{"function M10", "function M11", "function M31", "function M33", "function M60"}));
  EXPECT_FALSE(run.tells("fanuc-m-function")) << "they are known";
}

}  // namespace
}  // namespace proveout::test

// The run loop that controls share, with a control of this test's own: blocks are words of a small language.
#include "core/nc/flow/run_loop.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/flow/run_watch.h"

namespace proveout::nc {
namespace {

/// "call A B T" runs the blocks A to B - 1 T times, and says "behind" when they have returned; "back"
/// returns; "goto A", "wait", "end"; "bad" cannot be read, "fail" not be carried out; "/" is skipped, "" is
/// empty. Every other block is noted with its depth and repetition.
class TestControl : private FlowControl<FlowFrame> {
 public:
  explicit TestControl(std::vector<std::string> blocks, const ControlSettings& settings = {})
      : blocks_(std::move(blocks)),
        settings_(settings),
        watch_(
            summary_, nullptr, settings.block_limit, [] { return std::vector<LoopBudget::Named>{}; },
            [this](const char* what, const std::string& message) { tell(what, message); }) {}

  std::string run() {
    if (start()) loop_.run();
    return notes_;
  }
  bool start() { return loop_.openMain(blocksFrom(0, blocks_.size())); }
  Go advance() { return loop_.advance(); }
  const std::string& notes() const { return notes_; }
  const InterpretSummary& summary() const { return summary_; }

 private:
  FlowFrame blocksFrom(std::size_t first, std::size_t end) const {
    FlowFrame frame;
    frame.first = first;
    frame.end = end;
    return frame;
  }
  void note(const std::string& what) { notes_ += (notes_.empty() ? "" : " ") + what; }
  const std::string& block() const { return blocks_[frames_.back().block]; }
  std::size_t word(int index) const {
    std::size_t at = 0;
    for (int k = 0; k < index; ++k) at = block().find(' ', at) + 1;
    return static_cast<std::size_t>(std::atoi(block().c_str() + at));
  }

  Go due() override {
    if (later_.end == 0) return Go::kOn;
    return loop_.call(std::exchange(later_, {}), 1);
  }
  Reading read() override {
    frames_.back().number = static_cast<std::int64_t>(10 * frames_.back().block);
    if (block().empty()) return Reading::kEmpty;
    return block() == "/" ? Reading::kSkipped : block() == "bad" ? Reading::kBad : Reading::kBlock;
  }
  bool workOver() override {
    const FlowPlace at = flowPlace(frames_);
    return watch_.workOver(at) || watch_.goesRound(at, 0, {}) || watch_.goesOn(at);
  }
  void refuse() override { fail("refused"); }
  void fail(const std::string& what) {
    ++summary_.errors;
    note(what);
  }
  Go carryOut() override {
    if (block().starts_with("call")) {
      const Go go = loop_.call(blocksFrom(word(1), word(2)), static_cast<int>(word(3)));
      if (go == Go::kOn) note("never");
      return go;
    }
    if (block().starts_with("later")) {
      later_ = blocksFrom(word(1), word(2));
      return Go::kOn;
    }
    if (block() == "back") return Go::kReturn;
    if (block() == "end") return loop_.finish("end", ProgramEnd::kEndOfProgram);
    if (block().starts_with("goto")) loop_.jump(word(1));
    if (block() == "fail") {
      fail("failed");
      return loop_.failed();
    }
    if (block() == "wait") return Go::kWaits;
    if (!block().starts_with("goto"))
      note(block() + std::to_string(frames_.size()) + std::to_string(frames_.back().call.repetition));
    return Go::kOn;
  }
  Go resume() override {
    note("behind");
    return Go::kOn;
  }
  Go endOfText() override {
    return frames_.size() > 1 ? Go::kReturn : loop_.finish("text", ProgramEnd::kEndOfProgram);
  }
  bool opens() override {
    note("<");
    return true;
  }
  void closed(const FlowFrame& left) override { note(left.call.again() ? ">>" : ">"); }
  void recover() override { note("recovered"); }
  void giveUp() override { note("gave up"); }
  bool flush(ProgramEnd /*end*/) override { return true; }
  void sendEnd(const std::string& code) override { note(code); }
  void tell(const char* what, const std::string& /*message*/) override { fail(what); }
  const SourceText& text() const override { return text_; }
  std::size_t line() const override { return frames_.back().block; }

  std::vector<std::string> blocks_;
  ControlSettings settings_;
  SourceText text_{"test", "test", "G1 X1\n"};
  InterpretSummary summary_;
  std::vector<FlowFrame> frames_;
  FlowFrame later_;  ///< end 0: none
  std::string notes_;
  RunWatch watch_;
  RunLoop<FlowFrame> loop_{*this, frames_, summary_, settings_};
};

TEST(RunLoop, BlocksGoInTheirOrder) {
  TestControl control({"a", "", "/", "goto 5", "b", "c", "end", "d"});
  EXPECT_EQ(control.run(), "a10 c10 end");
  EXPECT_EQ(control.summary().blocks, 4u);
  EXPECT_EQ(control.summary().end, ProgramEnd::kEndOfProgram);
  EXPECT_EQ(TestControl({"a"}).run(), "a10 text");
}

TEST(RunLoop, CallsAreRepeatedAndTheBlockGoesOnBehindThem) {
  EXPECT_EQ(TestControl({"call 3 5 2", "a", "end", "b", "back", "c"}).run(),
            "< b20 >> < b21 > behind a10 end");
  EXPECT_EQ(TestControl({"call 2 3 0", "end", "b"}).run(), "never end");
  // One inside the other, the inner one at the end of its text.
  EXPECT_EQ(TestControl({"call 2 4 2", "end", "call 4 5 1", "a", "b"}).run(),
            "< < b30 > behind a20 >> < < b30 > behind a21 > behind end");
}

TEST(RunLoop, WaitsAndGoesOn) {
  TestControl control({"call 2 5 1", "end", "a", "wait", "b"});
  ASSERT_TRUE(control.start());
  EXPECT_EQ(control.advance(), Go::kOn);
  EXPECT_EQ(control.advance(), Go::kOn);
  EXPECT_EQ(control.advance(), Go::kWaits);
  EXPECT_EQ(control.notes(), "< a20");
  EXPECT_EQ(control.advance(), Go::kOn);
  while (control.advance() == Go::kOn) {
  }
  EXPECT_EQ(control.notes(), "< a20 b20 > behind end");
}

TEST(RunLoop, WhatIsDueComesBeforeTheNextBlock) {
  TestControl control({"later 3 4", "a", "end", "b"});
  EXPECT_EQ(control.run(), "< b20 > behind a10 end");
  EXPECT_EQ(control.summary().blocks, 4u);
}

TEST(RunLoop, ErrorsStopTheRunWhenThereAreTooMany) {
  ControlSettings settings;
  settings.max_errors = 2;
  TestControl one({"a", "bad", "b", "end"}, settings);
  EXPECT_EQ(one.run(), "a10 refused recovered b10 end");
  EXPECT_EQ(one.summary().end, ProgramEnd::kEndOfProgram);
  TestControl two({"a", "bad", "fail", "b"}, settings);
  EXPECT_EQ(two.run(), "a10 refused recovered failed recovered gave up");
  EXPECT_EQ(two.summary().end, ProgramEnd::kAlarm);
}

TEST(RunLoop, StopsBehindTheBlockOfTheJobWithItsCalls) {
  ControlSettings settings;
  settings.until.emplace();
  settings.until->line = 1;
  TestControl called({"call 3 4 1", "a", "end", "b"}, settings);
  EXPECT_EQ(called.run(), "< b20 > behind until");
  EXPECT_EQ(called.summary().end, ProgramEnd::kUntil);
  settings.until->line = 4;  // inside a call: not of the main program
  TestControl inside({"call 3 4 1", "a", "end", "b"}, settings);
  EXPECT_EQ(inside.run(), "< b20 > behind a10 until");
  EXPECT_EQ(inside.summary().end, ProgramEnd::kAlarm);
}

TEST(RunLoop, EndlessLoopsAreTold) {
  TestControl control({"a", "goto 0"});
  EXPECT_TRUE(control.run().ends_with("endless-loop"));
  EXPECT_EQ(control.summary().end, ProgramEnd::kBlockLimit);
  ControlSettings settings;
  settings.block_limit = 100;
  TestControl calls({"call 1 2 1000", "a"}, settings);
  EXPECT_TRUE(calls.run().ends_with("block-limit"));
  EXPECT_LE(calls.summary().blocks, 101u);
}

/// A watch of a program of ten blocks that goes round its first two.
struct Watched {
  InterpretSummary summary;
  FlowFrame main;
  std::string told;
  RunWatch watch{summary,
                 nullptr,
                 1000,
                 [] { return std::vector<LoopBudget::Named>{}; },
                 [this](const char* /*what*/, const std::string& message) { told = message; },
                 100};
  Watched() { main.end = 10; }
  FlowPlace next() {
    summary.blocks += 100;
    main.block = 1 - main.block;
    return {main, main, 1, main.block};
  }
};

TEST(RunWatch, MotionsOfABlockBeyondTheFreeOnesCount) {
  Watched run;
  run.summary.motions = 100;
  EXPECT_FALSE(run.watch.workOver(run.next()));
  run.summary.motions += 100 + 998;
  EXPECT_FALSE(run.watch.workOver(run.next()));
  EXPECT_TRUE(run.watch.workOver(run.next()));
  EXPECT_TRUE(run.told.starts_with("1000 blocks executed without an end, chords of curves included"));
  EXPECT_EQ(run.summary.end, ProgramEnd::kBlockLimit);
}

TEST(RunWatch, BlocksThatAskForOtherChannelsAreNoLoop) {
  Watched alone, asks;
  bool ends = false;
  for (int k = 0; k < 1000; ++k) {
    ends = ends || alone.watch.goesOn(alone.next());
    EXPECT_FALSE(asks.watch.movesOn(asks.next()));
  }
  EXPECT_TRUE(ends);
  EXPECT_TRUE(alone.told.starts_with("an endless loop"));
  ends = false;
  for (int k = 0; k < 1000; ++k) {
    asks.summary.motions += 100;
    ends = ends || asks.watch.movesOn(asks.next());
  }
  EXPECT_TRUE(ends);
}

}  // namespace
}  // namespace proveout::nc

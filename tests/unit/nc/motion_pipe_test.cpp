#include "core/nc/stages/motion_pipe.h"

#include <gtest/gtest.h>

#include <deque>
#include <string>

namespace proveout::nc {
namespace {

/// Writes down what comes by.
class Tape final : public PathStage {
 public:
  explicit Tape(StageSlot slot = StageSlot::kEmit) : PathStage(slot) {}
  bool push(PathItem& item) override {
    text += item.function() ? fmt(item.value, 'f') : fmt(item.to[0], 'm');
    return true;
  }
  std::string text;

 private:
  static std::string fmt(double value, char kind) {
    return kind + std::to_string(static_cast<int>(value)) + " ";
  }
};

/// Keeps one motion back and doubles it; functions wait behind it.
class Doubler final : public PathStage {
 public:
  Doubler(StageSlot slot, MotionPipe& pipe) : PathStage(slot), pipe_(pipe) {}
  bool push(PathItem& item) override {
    if (!item.function() && !flush(FlushReason::kBuffer)) return false;
    waiting_.push_back(std::move(item));
    return true;
  }
  bool flush(FlushReason reason) override {
    if (reason == FlushReason::kTransform) return true;
    for (PathItem& item : waiting_) {
      PathItem copy = item.copyMotion();
      copy.to[0] += 1.0;
      const bool twice = !item.function();
      if (!pass(item) || (twice && !pass(copy))) return false;
    }
    waiting_.clear();
    return true;
  }
  void clear() override {
    waiting_.clear();
    pipe_.unlink(*this);
  }

 private:
  MotionPipe& pipe_;
  std::deque<PathItem> waiting_;
};

void move(MotionPipe& pipe, double x) {
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.to[0] = x;
  EXPECT_TRUE(pipe.push(item));
}

void dwell(MotionPipe& pipe, double seconds) {
  PathItem item;
  item.kind = PathItem::Kind::kDwell;
  item.value = seconds;
  EXPECT_TRUE(pipe.push(item));
}

TEST(MotionPipe, StagesThatAreNotLinkedAreNotThere) {
  MotionPipe pipe;
  Tape tape;
  pipe.link(tape);
  move(pipe, 1);
  dwell(pipe, 2);
  EXPECT_EQ(tape.text, "m1 f2 ");
}

TEST(MotionPipe, FunctionsKeepTheirPlaceAmongMotions) {
  MotionPipe pipe;
  Tape tape;
  Doubler doubler(StageSlot::kComp, pipe);
  pipe.link(tape);
  pipe.link(doubler);
  move(pipe, 10);
  dwell(pipe, 1);
  move(pipe, 20);
  EXPECT_EQ(tape.text, "m10 m11 f1 ");
  EXPECT_TRUE(pipe.flush(FlushReason::kTransform));
  EXPECT_EQ(tape.text, "m10 m11 f1 ");
  EXPECT_TRUE(pipe.flush(FlushReason::kEnd));
  EXPECT_EQ(tape.text, "m10 m11 f1 m20 m21 ");
}

TEST(MotionPipe, StagesStandInTheOrderOfTheirSlotsWheneverTheyAreLinked) {
  MotionPipe pipe;
  Tape tape;
  Doubler first(StageSlot::kContour, pipe), second(StageSlot::kComp, pipe);
  pipe.link(second);
  pipe.link(tape);
  pipe.link(first);
  move(pipe, 10);
  EXPECT_TRUE(pipe.flush(FlushReason::kBuffer));  // the first stage's items reach the second before its turn
  EXPECT_EQ(tape.text, "m10 m11 m11 m12 ");
}

TEST(MotionPipe, ClearForgetsAndUnlinks) {
  MotionPipe pipe;
  Tape tape;
  Doubler doubler(StageSlot::kCorner, pipe);
  pipe.link(tape);
  pipe.link(doubler);
  move(pipe, 10);
  pipe.clear();
  EXPECT_FALSE(doubler.linked());
  move(pipe, 5);
  EXPECT_EQ(tape.text, "m5 ");
}

}  // namespace
}  // namespace proveout::nc

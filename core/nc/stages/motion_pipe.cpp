#include "core/nc/stages/motion_pipe.h"

#include <fmt/core.h>

#include <cmath>

#include "core/base/assert.h"

namespace proveout::nc {
namespace {

const char* spindleName(SpindleState state) {
  switch (state) {
    case SpindleState::kClockwise:
      return "cw";
    case SpindleState::kCounterClockwise:
      return "ccw";
    case SpindleState::kOriented:
      return "oriented";
    case SpindleState::kPositionLoop:
      return "position loop";
    case SpindleState::kStopped:
      break;
  }
  return "stop";
}

}  // namespace

void MotionPipe::link(PathStage& stage) {
  PathStage*& slot = stages_[static_cast<std::size_t>(stage.slot_)];
  PROVEOUT_ASSERT(slot == nullptr || slot == &stage);
  slot = &stage;
  stage.linked_ = true;
  join();
}

void MotionPipe::unlink(PathStage& stage) {
  if (!stage.linked_) return;
  PathStage*& slot = stages_[static_cast<std::size_t>(stage.slot_)];
  PROVEOUT_ASSERT(slot == &stage);
  slot = nullptr;
  stage.linked_ = false;  // keeps its way on: it may be in the middle of passing items
  join();
}

void MotionPipe::join() {
  PathStage* behind = nullptr;
  for (std::size_t k = kStageSlots; k-- > 0;) {
    if (stages_[k] == nullptr) continue;
    stages_[k]->next_ = behind;
    behind = stages_[k];
  }
  first_ = behind;
}

bool MotionPipe::flush(FlushReason reason) {
  for (std::size_t k = 0; k < kStageSlots; ++k) {
    if (stages_[k] != nullptr && !stages_[k]->flush(reason)) return false;
  }
  return true;
}

void MotionPipe::rebase(const AxisPoint& work, const WorkPlane& plane) {
  for (PathStage* stage : stages_) {
    if (stage != nullptr) stage->rebase(work, plane);
  }
}

void MotionPipe::clear() {
  for (std::size_t k = 0; k < kStageSlots; ++k) {
    if (stages_[k] != nullptr) stages_[k]->clear();
  }
}

bool FrameStage::push(PathItem& item) {
  if (item.space == PathItem::Space::kWork && !item.function()) {
    if (item.kind == PathItem::Kind::kArc) {
      AxisPoint center = item.plane.point(item.center);
      chain_.moveToMachine(center);
      const bool main = item.plane.u < kMainAxes && item.plane.v < kMainAxes;
      item.center = main ? center.xyz : item.plane.of(center);
      if (main) item.normal = chain_.directionToMachine(Vec3::Unit(item.plane.w));
      if (chain_.turnsArcs(item.plane.u, item.plane.v)) item.sweep = -item.sweep;
    }
    if (item.feed.join.inside != 0) {
      item.feed.join.normal = chain_.directionToMachine(Vec3::Unit(item.plane.w));
      if (chain_.turnsArcs(item.plane.u, item.plane.v)) item.feed.join.inside = -item.feed.join.inside;
    }
    chain_.moveToMachine(item.to);
    item.space = PathItem::Space::kMachine;
  }
  return pass(item);
}

bool EmitStage::push(PathItem& item) {
  item.feed.compensated = item.feed.compensated || item.comp_on;
  if (item.function()) {
    function(item);
  } else if (item.pose) {
    emitter_.poseTo(item.to, *item.pose, item.rapid ? nullptr : &item.feed, item.source);
  } else if (item.in_polar) {
    polar(item);
  } else if (item.kind == PathItem::Kind::kArc) {
    emitter_.arcTo(item.to, {item.center, item.normal, item.sweep, item.plane}, item.feed, item.source);
  } else if (item.kind == PathItem::Kind::kLine && item.rapid) {
    emitter_.rapidTo(item.to, item.source, item.rapid_speed);
  } else if (item.kind == PathItem::Kind::kLine) {
    emitter_.lineTo(item.to, item.feed, item.source);
  }
  return true;
}

void EmitStage::polar(const PathItem& item) {
  std::optional<PolarArc> arc;
  if (item.kind == PathItem::Kind::kArc) arc = PolarArc{item.center.head<2>(), item.sweep};
  emitter_.polarTo(item.to, item.polar, arc, item.rapid ? nullptr : &item.feed, item.source);
}

void EmitStage::function(PathItem& item) {
  switch (item.kind) {
    case PathItem::Kind::kSpindle: {
      const double ramp_s = emitter_.spindleRamp(item.value);
      emitter_.setSpindle(item.value);
      event::Spindle spindle = item.event ? std::get<event::Spindle>(*item.event) : event::Spindle{};
      spindle.rpm = std::abs(item.value);
      spindle.direction = spindleName(item.spindle);
      emitter_.event(std::move(spindle), ramp_s, item.source);
      break;
    }
    case PathItem::Kind::kToolChange: {
      const int tool = static_cast<int>(item.value);
      emitter_.setTool(tool);
      event::ToolChange change = item.event ? std::get<event::ToolChange>(*item.event) : event::ToolChange{};
      change.tool = tool;
      emitter_.event(std::move(change), tool_change_s_, item.source);
      break;
    }
    case PathItem::Kind::kDwell:
      emitter_.event(event::Dwell{item.value}, item.value, item.source);
      break;
    default:
      if (item.event) emitter_.event(std::move(*item.event), item.value, item.source);
      break;
  }
}

}  // namespace proveout::nc

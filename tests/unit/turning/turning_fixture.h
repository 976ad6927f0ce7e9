// Paths and tools for tests of turning.
#pragma once

#include <vector>

#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/turning/turned_stock.h"

namespace proveout {

/// A tool path in the plane of the spindle axis; points are (radius, z) of the control point.
class TurningPath {
 public:
  explicit TurningPath(Vec2 start) : at_(start) { path.files = {"test"}; }

  TurningPath& rapid(double r, double z) { return move(MotionKind::kRapid, r, z); }
  TurningPath& feed(double r, double z) { return move(MotionKind::kFeed, r, z); }
  /// About (center_r, center_z); `sweep_rad` from +r towards +z.
  TurningPath& arc(double r, double z, const Vec2& center, double sweep_rad) {
    move(MotionKind::kFeed, r, z);
    ArcGeometry arc;
    arc.center = Vec3(center.x(), 0.0, center.y());
    arc.normal = -Vec3::UnitY();
    arc.sweep_rad = sweep_rad;
    path.arcs.push_back(arc);
    path.motions.back().arc = static_cast<std::int32_t>(path.arcs.size()) - 1;
    return *this;
  }
  /// `turns` of a spindle at 1000 1/min.
  TurningPath& thread(double r, double z, double turns, double start_deg = 0.0) {
    const Vec2 from = at_;
    move(MotionKind::kThread, r, z);
    path.motions.back().feed = (at_ - from).norm() / turns * 1000.0;
    path.motions.back().thread_start_deg = static_cast<float>(start_deg);
    return *this;
  }
  TurningPath& tool(int number) {
    tool_ = number;
    return *this;
  }
  TurningPath& spindle(double rpm) {
    spindle_ = rpm;
    return *this;
  }

  Toolpath path;

 private:
  TurningPath& move(MotionKind kind, double r, double z) {
    Motion motion;
    motion.kind = kind;
    motion.from = Vec3(at_.x(), 0.0, at_.y());
    at_ = {r, z};
    motion.to = Vec3(r, 0.0, z);
    motion.tool = tool_;
    motion.feed = kind == MotionKind::kRapid ? 0.0 : 100.0;
    motion.spindle = spindle_;
    motion.source.line = static_cast<std::uint32_t>(path.motions.size()) + 1;
    path.motions.push_back(motion);
    return *this;
  }

  Vec2 at_;
  int tool_ = 1;
  double spindle_ = 1000.0;
};

inline Tool insertTool(int number, const Insert& insert) {
  Tool tool;
  tool.number = number;
  tool.type = ToolType::kInsert;
  tool.insert = insert;
  return tool;
}

/// For turning towards the chuck: 55 degrees, leading edge 93 degrees.
inline Insert turningInsert(double nose_radius, int orientation = 3) {
  Insert insert;
  insert.orientation = orientation;
  insert.nose_radius = nose_radius;
  insert.insert_angle_deg = 55.0;
  insert.lead_angle_deg = 93.0;
  insert.edge_length = 11.0;
  return insert;
}

inline Insert grooveInsert(double width, double corner_radius) {
  Insert insert;
  insert.shape = InsertShape::kGroove;
  insert.orientation = 3;
  insert.width = width;
  insert.nose_radius = corner_radius;
  insert.edge_length = 35.0;
  return insert;
}

/// A bar from z = -length to 0.
inline CylinderShape bar(double radius, double length, double bore = 0.0) {
  CylinderShape shape;
  shape.radius = radius;
  shape.inner_radius = bore;
  shape.length = length;
  shape.base = Vec3(0.0, 0.0, -length);
  return shape;
}

}  // namespace proveout

// A small driver for tests of cutter compensation: writes programs as calls, collects pieces and the first
// error.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "core/nc/services/cutter_comp.h"

namespace proveout::comp_test {

struct Expected {
  double x, y;
  std::optional<Vec2> center = std::nullopt;  ///< set: an arc
  std::optional<double> sweep_deg = std::nullopt;
};

class Mill {
 public:
  explicit Mill(Vec2 start, CutterCompPolicy policy = {}) : comp(policy) {
    at_ = {start.x(), start.y(), 0.0};
    comp.reset(at_);
  }
  /// Offset from the next block on: > 0 left (G41), < 0 right (G42).
  Mill& side(double offset) {
    active_ = true;
    offset_ = offset;
    return *this;
  }
  /// To which the points of further blocks are rounded, mm.
  Mill& decimal(double mm) {
    decimal_ = mm;
    return *this;
  }
  Mill& off() {
    active_ = false;
    offset_ = 0.0;
    return *this;
  }
  Mill& line(double x, double y) { return send(block(CompBlock::Shape::kLine, x, y)); }
  Mill& lineTowards(double x, double y, Vec2 direction) {
    CompBlock b = block(CompBlock::Shape::kLine, x, y);
    b.direction = direction;
    return send(b);
  }
  Mill& keep(double x, double y) {
    CompBlock b = block(CompBlock::Shape::kLine, x, y);
    b.keep_vector = true;
    return send(b);
  }
  /// Circle about (cx, cy) to (x, y); equal points make a full turn.
  Mill& arc(double x, double y, double cx, double cy, bool ccw) {
    CompBlock b = block(CompBlock::Shape::kArc, x, y);
    b.center = {cx, cy};
    const Vec2 s = at_.head<2>() - b.center, e = Vec2(x, y) - b.center;
    double sweep = std::atan2(s.x() * e.y() - s.y() * e.x(), s.dot(e));
    if (ccw && sweep <= 1e-9) sweep += 2 * kPi;
    if (!ccw && sweep >= -1e-9) sweep -= 2 * kPi;
    b.sweep_rad = sweep;
    return send(b);
  }
  Mill& none(double w) {
    at_.z() = w;
    return send(block(CompBlock::Shape::kNone, at_.x(), at_.y()));
  }
  Mill& none() { return none(at_.z()); }
  Mill& cornerArc(std::optional<Vec2> direction = std::nullopt) {
    CompBlock b = block(CompBlock::Shape::kCornerArc, at_.x(), at_.y());
    b.direction = direction;
    return send(b);
  }
  /// The next block, not sent.
  CompBlock block(CompBlock::Shape shape, double x, double y) {
    CompBlock b;
    b.shape = shape;
    b.to = {x, y, at_.z()};
    b.active = active_;
    b.offset = offset_;
    b.decimal = decimal_;
    b.tag = ++tag;
    return b;
  }
  Mill& flush() {
    if (status.ok()) status = comp.flush(out);
    return *this;
  }
  Mill& halt(const CompBlock& refused) {
    if (status.ok()) status = comp.halt(refused, out);
    return *this;
  }

  /// Ends of all pieces that move in the plane.
  std::vector<CompPiece> moves() const {
    std::vector<CompPiece> result;
    for (const CompPiece& p : out.pieces) {
      if (p.is_arc || (p.to - p.from).head<2>().norm() > 0.0) result.push_back(p);
    }
    return result;
  }

  void expectPath(const std::vector<Expected>& expected, double tolerance = 6e-4) const {
    EXPECT_EQ(static_cast<int>(status.error), 0) << "tag " << status.tag;
    const auto pieces = moves();
    for (std::size_t i = 0; i < std::max(pieces.size(), expected.size()); ++i) {
      if (i >= pieces.size() || i >= expected.size()) {
        ADD_FAILURE() << pieces.size() << " pieces, expected " << expected.size();
        if (i < pieces.size()) ADD_FAILURE() << "extra to " << pieces[i].to.transpose();
        break;
      }
      const Expected& e = expected[i];
      EXPECT_NEAR((pieces[i].to.head<2>() - Vec2(e.x, e.y)).norm(), 0.0, tolerance)
          << "piece " << i << " ends at " << pieces[i].to.transpose() << ", expected " << e.x << " " << e.y;
      EXPECT_EQ(pieces[i].is_arc, e.center.has_value()) << "piece " << i;
      if (e.center && pieces[i].is_arc) {
        EXPECT_NEAR((pieces[i].center - *e.center).norm(), 0.0, tolerance) << "piece " << i;
      }
      if (e.sweep_deg) {
        EXPECT_NEAR(radToDeg(pieces[i].sweep_rad), *e.sweep_deg, 2e-3) << "piece " << i;
      }
    }
    expectContinuous();
  }
  void expectContinuous() const {
    for (std::size_t i = 1; i < out.pieces.size(); ++i) {
      EXPECT_EQ(out.pieces[i].from, out.pieces[i - 1].to) << "piece " << i;
    }
  }

  CutterComp comp;
  CompOutput out;
  CompStatus status;
  std::uint64_t tag = 0;  ///< of the last block

 private:
  Mill& send(const CompBlock& b) {
    at_ = b.to;
    if (status.ok()) status = comp.push(b, out);
    return *this;
  }

  Vec3 at_ = Vec3::Zero();
  bool active_ = false;
  double offset_ = 0.0, decimal_ = 0.0;
};

}  // namespace proveout::comp_test

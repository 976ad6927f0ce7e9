#include "core/nc/iso/stages/axis_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/nc/services/virtual_plane.h"
#include "core/nc/stages/axis_arc.h"

namespace proveout::nc {
namespace {

bool isMainPlane(const WorkPlane& plane) { return plane.u < kMainAxes && plane.v < kMainAxes; }

bool carriesNothing(const AxisInfo& axis, const ControlSettings& settings) {
  const int k = settings.machine ? settings.machine->find(axis.name) : -1;
  if (k >= 0) return settings.machine->axes[static_cast<std::size_t>(k)].side == AxisSide::kNothing;
  return axis.rotary() ? !axis.turns : axis.parallel_to < 0;
}

}  // namespace

AxisStage::AxisStage(const AxisMap& map, const PathEmitter& emitter, const AxisTable& axes,
                     const ControlSettings& settings)
    : PathStage(StageSlot::kAxes), map_(map), emitter_(emitter), axes_(axes) {
  for (int k = kMainAxes; k < axes.count(); ++k)
    idle_.set(static_cast<std::size_t>(k), carriesNothing(axes.at(k), settings));
}

bool AxisStage::push(PathItem& item) {
  if (item.function() || item.space != PathItem::Space::kMachine) return pass(item);
  const AxisPoint from = last_ ? *last_ : map_.namesAt(emitter_.machine());
  const AxisPoint to = map_.followed(item.to);
  last_ = to;
  if (item.pose) {  // slaves and parked axes along the way, too
    item.pose->at = [this, at = std::move(item.pose->at)](double share) {
      return map_.axesAt(map_.followed(at(share)));
    };
  }
  if (item.kind != PathItem::Kind::kArc) return pushLine(item, from, to);
  if (!keepsArc(item)) return pushChords(item, from, to);
  item.to = map_.axesAt(to);
  putOnAxes(item);
  return pass(item);
}

/// What F is the speed of, without slaves.
double AxisStage::programmedLength(const AxisPoint& from, const AxisPoint& to) const {
  double sum = 0.0;
  for (int name = 0; name < axes_.count(); ++name) {
    const double d = map_.isSlave(name) ? 0.0 : to[name] - from[name];
    sum += d * d;
  }
  return std::sqrt(sum);
}

bool AxisStage::pushLine(PathItem& item, const AxisPoint& from, const AxisPoint& to) {
  const bool counts = map_.slaves().any() || map_.parked().any();
  if (counts && !item.rapid && item.feed.paced_mm == 0.0) item.feed.paced_mm = programmedLength(from, to);
  item.to = map_.axesAt(to);
  putOnAxes(item);
  return pass(item);
}

/// Whether the axes that move something go along an arc too.
bool AxisStage::keepsArc(const PathItem& item) const {
  const AxisSet moving = ~idle_;
  if ((map_.slaves() & moving).any() || (map_.parked() & moving).any()) return false;
  if (!map_.exchanged()) return true;
  bool stays = isMainPlane(item.plane);
  for (int name = 0; name < kMainAxes; ++name) stays = stays && map_.axisOf(name) < kMainAxes;
  return stays;
}

/// The planes of the item under the axes' own names, and slaves that its feed leaves out.
void AxisStage::putOnAxes(PathItem& item) const {
  item.feed.slaves = map_.slaves();
  if (!map_.exchanged()) return;
  Mat3 turn = Mat3::Zero();
  for (int name = 0; name < kMainAxes; ++name) {
    if (map_.axisOf(name) >= kMainAxes) return;  // no arc comes here, and no corner has an inside
    turn(map_.axisOf(name), name) = 1.0;
  }
  const double sense = turn.determinant() < 0.0 ? -1.0 : 1.0;
  item.feed.join.normal = turn * item.feed.join.normal;
  item.feed.join.inside *= static_cast<int>(sense);
  if (item.kind != PathItem::Kind::kArc) return;
  item.center = turn * item.center;
  item.normal = turn * item.normal;
  item.sweep *= sense;
  item.plane = WorkPlane(map_.axisOf(item.plane.u), map_.axisOf(item.plane.v), map_.axisOf(item.plane.w));
}

bool AxisStage::pushChords(const PathItem& item, const AxisPoint& from, const AxisPoint& to) {
  const AxisArc arc(from, to, {item.center, item.normal, item.sweep, item.plane});
  AxisSet apart;
  for (int name = 0; name < axes_.count(); ++name)
    apart.set(static_cast<std::size_t>(name), map_.isSlave(name));
  const double paced = arc.pacedLength(item.feed, axes_.count(), apart);
  double done = 0.0;
  bool good = true;
  const auto chord = [&](double t) {
    PathItem line = item.copyMotion();
    line.kind = PathItem::Kind::kLine;
    line.feed.paced_mm = paced * (t - done);
    line.to = map_.axesAt(arc.at(t));
    putOnAxes(line);
    good = good && pass(line);
    done = t;
  };
  const auto shape = [&](double t) {  // as a curve of space
    const AxisPoint p = arc.at(t);
    return arc.isMain() ? p.xyz : Vec3(p[item.plane.u], p[item.plane.v], 0.0);
  };
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(item.sweep) / kCurvePieceRad)));
  divideCurve(shape, pieces, kCurveChordMm, chord);
  return good;
}

}  // namespace proveout::nc

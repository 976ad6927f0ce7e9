#include "core/nc/iso/context/sends.h"

#include <memory>
#include <utility>

namespace proveout::nc {

PathItem functionItem(const IsoContext& c, PathItem::Kind kind, const IsoState& state) {
  PathItem item;
  item.kind = kind;
  item.plane = c.state.workPlane();
  item.to = c.position;
  item.comp_on = state.compOn();
  item.offset = state.compOffset();
  item.source = c.here();
  return item;
}

bool sendEvent(IsoContext& c, EventKind what, double time_s) {
  PathItem item = functionItem(c, PathItem::Kind::kEvent, c.state);
  item.event = std::make_unique<EventKind>(std::move(what));
  item.value = time_s;
  return c.pipe.push(item);
}

bool sendMachineRapid(IsoContext& c, const AxisPoint& to) {
  PathItem item;
  item.kind = PathItem::Kind::kLine;
  item.space = PathItem::Space::kMachine;
  item.rapid = true;
  item.to = to;
  item.source = c.here();
  return c.pipe.push(item);
}

}  // namespace proveout::nc

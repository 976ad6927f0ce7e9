#include "removal/wire/contact/wire_handling.h"

#include <algorithm>
#include <optional>

#include "core/base/assert.h"
#include "core/tool/tool_table.h"
#include "removal/wire/section/ruled_way.h"

namespace proveout {
namespace {

const WireSweep* wireOf(const Toolpath& path, MotionId id) {
  PROVEOUT_ASSERT(id < path.motions.size());
  const Motion& motion = path.motions[id];
  PROVEOUT_ASSERT(motion.wire < 0 || static_cast<std::size_t>(motion.wire) < path.wires.size());
  return motion.wire < 0 ? nullptr : &path.wires[static_cast<std::size_t>(motion.wire)];
}

/// How many stretches come before a motion.
std::uint32_t cutsBefore(const WireWork& work, MotionId id) {
  PROVEOUT_ASSERT_DEAR(std::ranges::is_sorted(work.cuts, {}, &WireStretch::motion));
  const auto at = std::lower_bound(work.cuts.begin(), work.cuts.end(), id,
                                   [](const WireStretch& s, MotionId motion) { return s.motion < motion; });
  return static_cast<std::uint32_t>(at - work.cuts.begin());
}

/// The motions in front of which the wire is threaded, in their order.
std::vector<MotionId> threadedBefore(const Toolpath& path, const std::vector<Contact>& contacts) {
  std::vector<MotionId> out;
  const auto count = static_cast<MotionId>(path.motions.size());
  for (MotionId id = 0; id < count; ++id) {
    const WireSweep* first = wireOf(path, id);
    if (first == nullptr) continue;
    if (first->state.threaded) out.push_back(id);
    break;
  }
  for (const Toolpath::EventAt& at : path.events) {
    const auto* wire = at.event.as<event::Wire>();
    if (wire != nullptr && wire->threaded && at.before < count) out.push_back(at.before);
  }
  for (const Contact& contact : contacts) {
    if (contact.kind != ContactKind::kByHand) continue;
    MotionId id = contact.last;
    while (id < count && wireOf(path, id) != nullptr && wireOf(path, id)->state.by_hand) ++id;
    if (id < count) out.push_back(id);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// The first motion behind `id` before which the program stops or the wire is cut; none if there is no such
/// motion.
std::optional<MotionId> nextStop(const Toolpath& path, MotionId id) {
  for (const Toolpath::EventAt& at : path.events) {
    if (at.before <= id) continue;
    const auto* wire = at.event.as<event::Wire>();
    const auto* maybe = at.event.as<event::OptionalStop>();
    if (at.event.as<event::Stop>() != nullptr || (maybe != nullptr && maybe->active) ||
        (wire != nullptr && !wire->threaded))
      return at.before;
  }
  return std::nullopt;
}

}  // namespace

void tellByHand(const Toolpath& path, std::vector<Contact>& contacts) {
  for (Contact& contact : contacts) {
    const WireSweep* wire = wireOf(path, contact.motion);
    if (wire != nullptr && wire->state.by_hand) contact.kind = ContactKind::kByHand;
  }
}

std::vector<ThreadingPlace> threadingPlaces(const Toolpath& path, const std::vector<Tool>& tools,
                                            const WireWork& work, const std::vector<Contact>& contacts,
                                            double z) {
  const ToolTable table(tools);
  std::vector<ThreadingPlace> places;
  for (const MotionId id : threadedBefore(path, contacts)) {
    const WireSweep* wire = wireOf(path, id);
    const Tool* tool = table.ofMotion(path.motions[id].tool);
    if (wire == nullptr || tool == nullptr) continue;
    places.push_back({RuledWay(*wire).at(0.0, z).head<2>(), tool->diameter, cutsBefore(work, id), id});
  }
  return places;
}

std::vector<FallenPiece> fallenPieces(const Toolpath& path, const WireWork& work, double height_mm,
                                      const std::vector<FreePiece>& pieces) {
  std::vector<FallenPiece> out;
  for (const FreePiece& piece : pieces) {
    PROVEOUT_ASSERT(piece.closed < work.cuts.size());
    const WireStretch& closing = work.cuts[piece.closed];
    FallenPiece fallen;
    fallen.motion = closing.motion;
    fallen.volume_mm3 = piece.body.area_mm2 * height_mm;
    const Vec2 at = placeIn(piece.body);
    fallen.where = Vec3(at.x(), at.y(), 0.0);
    const std::optional<MotionId> stop = nextStop(path, closing.motion);
    const auto end = stop ? cutsBefore(work, *stop) : static_cast<std::uint32_t>(work.cuts.size());
    const std::uint32_t through = firstThrough(piece, work.cuts, end);
    if (through < end) fallen.through = work.cuts[through].motion;
    out.push_back(fallen);
  }
  return out;
}

}  // namespace proveout

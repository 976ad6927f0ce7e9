#include "removal/wire/wire_stock.h"

#include <fmt/format.h>

#include <variant>

#include "core/tool/tool_table.h"
#include "removal/wire/kerf_section.h"
#include "removal/wire/wire_contacts.h"
#include "removal/wire/wire_handling.h"

namespace proveout {
namespace {

std::string placeOf(const Toolpath& path, const Motion& motion) {
  const std::string file =
      motion.source.file < path.files.size() ? path.files[motion.source.file] : std::string("the program");
  const std::string block = motion.source.block >= 0 ? fmt::format(" (N{})", motion.source.block) : "";
  return fmt::format("{}:{}{}", file, motion.source.line, block);
}

/// Why a motion's wire cannot be followed; empty: it can.
Status checkMotion(const Toolpath& path, const Motion& motion, const Tool* tool) {
  if (tool == nullptr)
    return inputError(fmt::format("{}: the job does not define tool {}", placeOf(path, motion), motion.tool));
  if (tool->type != ToolType::kWire)
    return inputError(
        fmt::format("{}: tool {} is no wire; give it type = \"wire\"", placeOf(path, motion), tool->number));
  if (!isUpright(path.wires[static_cast<std::size_t>(motion.wire)]))
    return inputError(fmt::format("{}: the wire leans here; cutting with a wire that leans is not built yet",
                                  placeOf(path, motion)));
  return Done{};
}

/// Leaves out stretches that go nowhere, if others join them.
void addMoving(const WireStretch& stretch, std::vector<WireStretch>& out) {
  const bool still = !stretch.isArc() && (stretch.to - stretch.from).norm() == 0.0;
  if (still && !out.empty() && (out.back().to - stretch.from).norm() == 0.0) return;
  out.push_back(stretch);
}

Result<WireWork> workOf(const Toolpath& path, const std::vector<Tool>& tools) {
  const ToolTable table(tools);
  WireWork work;
  std::vector<WireStretch> stretches;
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    const Motion& motion = path.motions[id];
    if (motion.wire < 0 || !path.wires[static_cast<std::size_t>(motion.wire)].state.threaded) continue;
    const Tool* tool = table.ofMotion(motion.tool);
    if (const Status good = checkMotion(path, motion, tool); !good) return good.error();
    stretches.clear();
    addStretches(path.wires[static_cast<std::size_t>(motion.wire)].lower,
                 0.5 * tool->diameter + tool->spark_gap, id, stretches);
    for (const WireStretch& stretch : stretches) {
      if (motion.kind == MotionKind::kFeed)
        addMoving(stretch, work.cuts);
      else if (motion.kind == MotionKind::kRapid)
        work.rapids.push_back({stretch, static_cast<std::uint32_t>(work.cuts.size())});
    }
  }
  return work;
}

/// Of a rapid only the wire itself counts, not its sparks.
void takeSparksAway(const Toolpath& path, const std::vector<Tool>& tools, WireWork& work) {
  const ToolTable table(tools);
  for (WireWork::Rapid& rapid : work.rapids)
    rapid.stretch.kerf_mm = 0.5 * table.ofMotion(path.motions[rapid.stretch.motion].tool)->diameter;
}

}  // namespace

Result<PrismBlank> prismOf(const StockShape& shape) {
  PrismBlank blank;
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    blank.loops.push_back(rectangleLoop(box->min.head<2>(), box->max.head<2>()));
    blank.z_low = box->min.z();
    blank.z_high = box->max.z();
    return blank;
  }
  const auto* cylinder = std::get_if<CylinderShape>(&shape);
  if (cylinder == nullptr || cylinder->axis != 2)
    return inputError("a wire cuts boxes, and cylinders and tubes along Z: no other stock");
  blank.loops.push_back(circleLoop(cylinder->base.head<2>(), cylinder->radius, false));
  if (cylinder->inner_radius > 0.0)
    blank.loops.push_back(circleLoop(cylinder->base.head<2>(), cylinder->inner_radius, true));
  blank.z_low = cylinder->base.z();
  blank.z_high = cylinder->base.z() + cylinder->length;
  return blank;
}

WireStock::WireStock(PrismBlank blank) : blank_(std::move(blank)) { bodies_ = cutSection(blank_.loops, {}); }

Result<RemovalSummary> WireStock::remove(const Toolpath& path, const std::vector<Tool>& tools,
                                         Progress& progress) {
  Result<WireWork> work = workOf(path, tools);
  if (!work) return work.error();
  takeSparksAway(path, tools, *work);
  progress.report("removing", 0.0);
  RemovalSummary summary;
  summary.removed_mm3.assign(path.motions.size(), 0.0F);
  std::vector<PlaneBody> last = cutSection(blank_.loops, work->cuts);
  const WireHolding holding(blank_.held_at, last);
  WireFalls falls = findFalls(blank_.loops, work->cuts, std::move(last), holding);
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  const std::vector<double> areas = removedAreas(blank_, work->cuts, falls.pieces);
  for (std::size_t i = 0; i < areas.size(); ++i)
    summary.removed_mm3[work->cuts[i].motion] +=
        static_cast<float>(areas[i] * (blank_.z_high - blank_.z_low));
  summary.contacts = rapidContacts(blank_, *work, holding, progress);
  tellByHand(path, summary.contacts);
  const std::vector<ThreadingPlace> places = threadingPlaces(path, tools, *work, summary.contacts);
  summary.threading = threadingFaults(blank_, *work, places, holding, progress);
  summary.fallen = fallenPieces(path, *work, blank_.z_high - blank_.z_low, falls.pieces);
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  bodies_ = std::move(falls.bodies);
  return summary;
}

double WireStock::initialVolume() const { return areaOf(blank_.loops) * (blank_.z_high - blank_.z_low); }

double WireStock::volume() const {
  double area = 0.0;
  for (const PlaneBody& body : bodies_) area += body.area_mm2;
  return area * (blank_.z_high - blank_.z_low);
}

}  // namespace proveout

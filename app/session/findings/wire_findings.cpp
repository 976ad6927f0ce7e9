#include "app/session/findings/wire_findings.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "app/session/findings/accounting.h"
#include "app/session/findings/blame.h"
#include "io/report_text.h"

namespace proveout {
namespace {

using report_text::figure;

/// The event behind which a motion follows with a wire that was just threaded.
const PathEvent* threadingBefore(const Toolpath& path, MotionId next) {
  const PathEvent* found = nullptr;
  for (const Toolpath::EventAt& at : path.events) {
    const auto* wire = at.event.as<event::Wire>();
    if (wire != nullptr && wire->threaded && at.before == next) found = &at.event;
  }
  return found;
}

std::string threadingText(const ThreadingFault& fault) {
  const std::string place = fmt::format("X{:.3f} Y{:.3f}", fault.where.x(), fault.where.y());
  if (!fault.hole_mm)
    return fmt::format(
        "there is no hole to thread the wire through at {}: the wire of {:g} mm needs a start hole that is "
        "wider "
        "than it ([[stock.start_hole]])",
        place, fault.wire_mm);
  if (*fault.hole_mm <= fault.wire_mm)
    return fmt::format(
        "the start hole of {:g} mm at {} is too small for the wire of {:g} mm: it has to be wider than that",
        *fault.hole_mm, place, fault.wire_mm);
  return fmt::format(
      "the wire of {:g} mm touches the wall of the start hole of {:g} mm where it is threaded, at {}: move "
      "it to "
      "the middle, or make the hole wider than {:.4g} mm",
      fault.wire_mm, *fault.hole_mm, place, fault.needs_mm);
}

void addThreading(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  const Toolpath& path = setup.interpreted.path;
  for (const ThreadingFault& fault : setup.removal.threading) {
    Finding finding(FindingKind::kThreading);
    finding.where = fault.where;
    blame(finding, fault.next, path, texts);
    if (const PathEvent* event = threadingBefore(path, fault.next))
      finding.source = blockRef(path, event->source, texts);
    finding.message = threadingText(fault);
    findings.push_back(std::move(finding));
  }
}

/// What a wire needs so that it cuts and does not break.
enum Supply : std::size_t { kRuns, kFluid, kCondition, kSupplies };
using Supplies = std::array<bool, kSupplies>;
constexpr std::array<std::string_view, kSupplies> kLacking{"the wire does not run", "there is no fluid",
                                                           "no cutting condition is chosen"};
constexpr std::array<std::string_view, kSupplies> kNever{"runs the wire", "switches the fluid on",
                                                         "chooses a cutting condition"};

Supplies suppliesOf(const WireState& state) { return {state.runs, state.fluid, state.condition}; }

/// "a, b and c" of the texts whose flag is set.
std::string joined(const Supplies& which, const std::array<std::string_view, kSupplies>& texts,
                   std::string_view last) {
  std::string out;
  std::size_t left = 0;
  for (const bool is : which) left += is ? 1 : 0;
  for (std::size_t k = 0; k < kSupplies; ++k) {
    if (!which[k]) continue;
    --left;
    out += out.empty() ? "" : left == 0 ? fmt::format(" {} ", last) : ", ";
    out += texts[k];
  }
  return out;
}

bool any(const Supplies& which) { return which != Supplies{}; }

class SupplyCheck {
 public:
  SupplyCheck(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings)
      : setup_(setup), path_(setup.interpreted.path), texts_(texts), findings_(findings) {
    for (const WireSweep& wire : path_.wires) {
      const Supplies on = suppliesOf(wire.state);
      for (std::size_t k = 0; k < kSupplies; ++k) programmed_[k] = programmed_[k] || on[k];
    }
  }

  void run() {
    const std::vector<float>& removed = setup_.removal.removed_mm3;
    for (MotionId id = 0; id < path_.motions.size() && id < removed.size(); ++id) {
      const Motion& motion = path_.motions[id];
      if (motion.wire < 0 || motion.kind != MotionKind::kFeed) continue;
      if (!isChip(removed[id], path_.length(motion))) continue;
      look(id, suppliesOf(path_.wires[static_cast<std::size_t>(motion.wire)].state));
    }
  }

 private:
  void look(MotionId id, const Supplies& on) {
    Supplies off{}, never{};
    for (std::size_t k = 0; k < kSupplies; ++k) (programmed_[k] ? off : never)[k] = !on[k];
    if (any(never) && !told_never_) {
      told_never_ = true;
      tell(id, Severity::kWarning,
           fmt::format("the program never {}, and cuts from here on: the operator has to",
                       joined(never, kNever, "nor")));
    }
    if (any(off) && off != before_)
      tell(id, Severity::kError, fmt::format("the wire cuts here while {}", joined(off, kLacking, "and")));
    else if (any(off))
      extend(id);
    before_ = off;
  }

  void tell(MotionId id, Severity severity, std::string message) {
    Finding finding(FindingKind::kWireSupply);
    finding.severity = severity;
    finding.where = path_.motions[id].from;
    finding.message = std::move(message);
    blame(finding, id, path_, texts_);
    findings_.push_back(std::move(finding));
  }

  /// The stretch that the last finding told of goes on.
  void extend(MotionId id) {
    Finding& finding = findings_.back();
    const BlockRef block = writtenBlock(path_, id, texts_).block;
    if (block.line != finding.source->line || block.file != finding.source->file) finding.last_source = block;
  }

  const SetupRun& setup_;
  const Toolpath& path_;
  const RecordingSource& texts_;
  std::vector<Finding>& findings_;
  Supplies programmed_{};  ///< somewhere in the path
  Supplies before_{};      ///< what the last cut lacked
  bool told_never_ = false;
};

void addFreeSlug(const FallenPiece& piece, const SetupRun& setup, const RecordingSource& texts,
                 std::vector<Finding>& findings) {
  if (piece.through == kNoMotion) return;
  const Toolpath& path = setup.interpreted.path;
  const BlockRef through = writtenBlock(path, piece.through, texts).block;
  Finding finding(FindingKind::kFreeSlug);
  finding.where = piece.where;
  finding.volume_mm3 = piece.volume_mm3;
  blame(finding, piece.motion, path, texts);
  finding.message = fmt::format(
      "slug of {} mm3 is free here, and {}:{} goes on through where it may still lie: put a stop before that "
      "and take the slug out, or hold it with a fixture",
      figure(piece.volume_mm3), through.file, through.line);
  findings.push_back(std::move(finding));
}

void addFreeSlugs(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  for (const FallenPiece& piece : setup.removal.fallen) addFreeSlug(piece, setup, texts, findings);
  for (const FallenPiece& piece : setup.removal.stuck) addFreeSlug(piece, setup, texts, findings);
}

void addStuckSlugs(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  for (const FallenPiece& piece : setup.removal.stuck) {
    Finding finding(FindingKind::kStuckSlug);
    finding.where = piece.where;
    finding.volume_mm3 = piece.volume_mm3;
    blame(finding, piece.motion, setup.interpreted.path, texts);
    finding.message =
        fmt::format("a piece of {} mm3 is free here, but its leaning walls keep it from falling out: {}",
                    figure(piece.volume_mm3),
                    piece.lifts ? "stop and lift it out upwards" : "it is locked in, up and down");
    findings.push_back(std::move(finding));
  }
}

void addBridges(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  for (const UncutBridge& bridge : setup.removal.bridges) {
    Finding finding(FindingKind::kBridge);
    finding.where = bridge.where;
    if (bridge.volume_mm3 > 0.0) finding.volume_mm3 = bridge.volume_mm3;
    blame(finding, bridge.motion, setup.interpreted.path, texts);
    const std::string piece = bridge.volume_mm3 > 0.0
                                  ? fmt::format("a piece of {} mm3 still hangs on", figure(bridge.volume_mm3))
                                  : std::string("a piece still hangs on, also");
    finding.message = fmt::format(
        "{} by a bridge of {:.3f} mm at X{:.3f} Y{:.3f}: the contour is not closed by {:.3f} mm of the "
        "wire's way",
        piece, bridge.width_mm, bridge.where.x(), bridge.where.y(), bridge.open_mm);
    findings.push_back(std::move(finding));
  }
}

}  // namespace

void addWireFindings(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  addThreading(setup, texts, findings);
  SupplyCheck(setup, texts, findings).run();
  addFreeSlugs(setup, texts, findings);
  addStuckSlugs(setup, texts, findings);
  addBridges(setup, texts, findings);
}

}  // namespace proveout

#include "app/session/findings/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "app/session/findings/blame.h"
#include "app/session/findings/feature_table.h"
#include "core/geometry/place_text.h"
#include "io/report_text.h"

namespace proveout {
namespace {

using report_text::figure;

/// Share of the blank below which nothing was cut: rounding of the volume sums stays far under it.
constexpr double kNothingCut = 1e-9;

/// Part of a volume that a grid may miss without a word: a round blank four cells thick stays within it.
constexpr double kHeldShare = 1e-3;
constexpr double kErrorShare = 2e-3;
/// Facets that may be off by more of a grid step than this show the surface badly there.
constexpr double kNotableOff = 0.5;

/// A cut that is this many grid steps wide holds a sample wherever it runs: more than the diagonal of a
/// square.
constexpr double kCellsInAWidth = 1.5;

/// The face of the CAD model that a patch is deepest at; null: none is known.
const CadFace* faceOf(const DeviationPatch& patch, const Comparison& comparison) {
  return comparison.nominal_faces == nullptr || patch.face == kNoFace
             ? nullptr
             : &comparison.nominal_faces->faces[patch.face];
}

/// Whether a patch is a hole that is not there: material up to its middle.
bool isMissing(const DeviationPatch& patch, const CadFace& face) {
  constexpr double kAll = 0.9;  // of the radius: a smaller drill leaves less
  return patch.kind == DeviationKind::kExcess && face.isWholeCylinder() && face.hollow &&
         patch.depth_mm > kAll * face.radius;
}

std::string deviationText(const DeviationPatch& patch, const Comparison& comparison) {
  std::string text =
      fmt::format("{} mm {} nominal over {} mm2", figure(patch.depth_mm),
                  patch.kind == DeviationKind::kGouge ? "below" : "above", figure(patch.area_mm2));
  if (patch.spots > 1) text += fmt::format(" in {} spots", patch.spots);
  text += fmt::format(" (allowed {:g} mm)", patch.allowed_mm);
  const CadFace* const face = faceOf(patch, comparison);
  if (face == nullptr) return text;
  if (isMissing(patch, *face))
    return fmt::format("the {} is missing or too short: {}", featureAt(patch.face, comparison), text);
  return fmt::format("{} at the {}", text, featureAt(patch.face, comparison));
}

Finding patchFinding(FindingKind kind, const DeviationPatch& patch) {
  Finding finding(kind);
  finding.where = patch.where;
  finding.depth_mm = patch.depth_mm;
  finding.area_mm2 = patch.area_mm2;
  finding.volume_mm3 = patch.volume_mm3;
  finding.bound_mm = patch.bound_mm;
  finding.spots = patch.spots;
  return finding;
}

/// The same with the feature that it is at.
Finding patchFinding(FindingKind kind, const DeviationPatch& patch, const Comparison& comparison) {
  Finding finding = patchFinding(kind, patch);
  if (faceOf(patch, comparison) != nullptr) finding.feature = featureAt(patch.face, comparison);
  return finding;
}

/// The coarsest grid that decides all of them; 0: none does.
double decidingResolution(const std::vector<DeviationPatch>& undecided) {
  double least = std::numeric_limits<double>::infinity();
  for (const DeviationPatch& patch : undecided) {
    if (patch.chord_mm == 0.0) least = std::min(least, patch.deciding_resolution_mm);
  }
  return std::isfinite(least) ? least : 0.0;
}

/// The profile resolution with which facets would be as good as the places ask for; they are off by a share
/// of it. 0: none that a job may ask for.
double decidingProfile(const Comparison& comparison, double profile_mm) {
  constexpr double kMargin = 0.8, kLeast = 1e-3;
  double factor = kMargin;
  for (const DeviationPatch& patch : comparison.undecided) {
    if (patch.chord_mm > 0.0) continue;  // not the part's facets
    factor = std::min(factor, kMargin * std::abs(patch.depth_mm - patch.allowed_mm) / patch.bound_mm);
  }
  return factor * profile_mm >= kLeast ? factor * profile_mm : 0.0;
}

/// Chords of a nominal that leave a verdict on its tolerances alone, mm.
double wantedChord(const Comparison& comparison) {
  constexpr double kWanted = 0.1;  // of the smaller tolerance
  return kWanted * std::min(comparison.gouge_tolerance_mm, comparison.excess_tolerance_mm);
}

/// What would decide, as the end of a sentence; empty: nothing is known to. `worst`: what the sentence tells.
std::string remedyText(const Comparison& comparison, const DeviationPatch& worst, double profile_mm) {
  if (worst.chord_mm > 0.0) {
    const double wanted = wantedChord(comparison);
    return fmt::format(
        ": the nominal's facets may lie {:.2g} mm off the face that they stand for; export it with {}",
        worst.chord_mm, wanted > 0.0 ? fmt::format("chords of {:.2g} mm", wanted) : "finer ones");
  }
  if (profile_mm > 0.0) {
    const double finer = decidingProfile(comparison, profile_mm);
    return finer > 0.0 ? fmt::format("; profile_resolution = {:.2g} in the job could", finer) : "";
  }
  const double grid = decidingResolution(comparison.undecided);
  return grid > 0.0 ? fmt::format("; --resolution {:.2g} could", grid) : "";
}

void addMeetings(std::size_t pairs, std::string_view whose, std::vector<Finding>& findings) {
  if (pairs == 0) return;
  Finding finding(FindingKind::kMesh);
  finding.severity = Severity::kWarning;
  finding.message = fmt::format(
      "{} pairs of {} triangles run through each other; another resolution of the grid, or "
      "profile_resolution, may part them",
      pairs, whose);
  findings.push_back(std::move(finding));
}

}  // namespace

void addAlarms(const Toolpath& path, std::vector<Finding>& findings) {
  for (const Diagnostic& diagnostic : path.diagnostics.all()) {
    if (diagnostic.severity != Severity::kError) continue;
    Finding finding(FindingKind::kAlarm);
    finding.message = diagnostic.message;
    if (diagnostic.where.line > 0) {
      finding.source = BlockRef{diagnostic.where.file, static_cast<std::uint32_t>(diagnostic.where.line), -1,
                                0, diagnostic.source_line};
    }
    findings.push_back(std::move(finding));
  }
}

namespace {

/// Whether all motions between two events are of one block; of commands that keep no motions, true.
bool goesOn(const Toolpath& path, const Toolpath::EventAt& last, const Toolpath::EventAt& now) {
  if (!sameBlock(last.event.source, now.event.source)) return false;
  const std::size_t end = std::min<std::size_t>(now.before, path.motions.size());
  for (std::size_t i = last.before; i < end; ++i) {
    if (!sameBlock(path.motions[i].source, now.event.source)) return false;
  }
  return true;
}

/// An axis that is beyond its limit in a block, as it was told last.
struct ToldOvertravel {
  Toolpath::EventAt at;
  event::Overtravel what;
  std::size_t finding;
};

}  // namespace

/// A block may go in many pieces: each axis is told once, with how far it goes.
void addOvertravel(const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings) {
  std::vector<ToldOvertravel> told;
  for (const Toolpath::EventAt& at : path.events) {
    const auto* overtravel = at.event.as<event::Overtravel>();
    if (overtravel == nullptr) continue;
    std::erase_if(told, [&](const ToldOvertravel& last) { return !goesOn(path, last.at, at); });
    const auto known = std::find_if(told.begin(), told.end(), [&](const ToldOvertravel& last) {
      return last.what.axis == overtravel->axis && last.what.limit == overtravel->limit;
    });
    if (known != told.end()) {
      known->at = at;
      const double limit = overtravel->limit;
      if (std::abs(overtravel->value - limit) <= std::abs(known->what.value - limit)) continue;
    }
    Finding finding(FindingKind::kOvertravel);
    finding.source = blockRef(path, at.event.source, texts);
    // The event precedes its motion.
    if (at.before < path.motions.size()) {
      finding.motion = at.before;
      finding.tool = path.motions[at.before].tool;
      finding.where = path.motions[at.before].to;
    }
    const bool rotary = std::string_view("ABC").find(overtravel->axis.front()) != std::string_view::npos;
    const char* const unit = rotary ? "deg" : "mm";
    finding.message = fmt::format("{0} goes to {1} {3}, past its limit of {2} {3} (machine frame)",
                                  overtravel->axis, overtravel->value + 0.0, overtravel->limit + 0.0, unit);
    if (known != told.end()) {
      known->what = *overtravel;
      findings[known->finding] = std::move(finding);
    } else {
      told.push_back({at, *overtravel, findings.size()});
      findings.push_back(std::move(finding));
    }
  }
}

namespace {

/// What is wrong with an axis in a feed motion; empty: nothing.
std::string clampFault(const MachineAxis& axis, const RotaryPosition& at) {
  constexpr double kStands = 1e-6;  // deg
  if ((axis.clamped || axis.step > 0.0) && std::abs(at.to - at.from) > kStands)
    return fmt::format(
        "axis {} turns from {:g} to {:g} degrees in a feed motion: it is clamped while a tool cuts",
        axis.name, at.from, at.to);
  if (axis.step > 0.0 && std::abs(std::remainder(at.to, axis.step)) > kStands)
    return fmt::format(
        "axis {} stands at {:g} degrees in a feed motion: its teeth hold whole steps of {:g} degrees",
        axis.name, at.to, axis.step);
  return {};
}

}  // namespace

void addClampedAxes(const MachineModel& machine, const Toolpath& path, const RecordingSource& texts,
                    std::vector<Finding>& findings) {
  std::set<std::string> told;
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    const Motion& motion = path.motions[id];
    if (motion.axis < 0 || motion.kind == MotionKind::kRapid) continue;
    const AxisSweep& sweep = path.axes[static_cast<std::size_t>(motion.axis)];
    for (int k = 0; k < sweep.rotary_count; ++k) {
      const RotaryPosition& at = sweep.rotary[static_cast<std::size_t>(k)];
      const int axis = machine.find(at.name.data());
      if (axis < 0 || told.contains(at.name.data())) continue;
      std::string fault = clampFault(machine.axes[static_cast<std::size_t>(axis)], at);
      if (fault.empty()) continue;
      told.insert(at.name.data());
      Finding finding(FindingKind::kClampedAxis);
      finding.source = blockRef(path, motion.source, texts);
      finding.motion = id;
      finding.tool = motion.tool;
      finding.where = motion.to;
      finding.message = std::move(fault);
      findings.push_back(std::move(finding));
    }
  }
}

void addForbiddenZones(const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings) {
  for (const Toolpath::EventAt& at : path.events) {
    const auto* zone = at.event.as<event::ForbiddenZone>();
    if (zone == nullptr) continue;
    Finding finding(FindingKind::kForbiddenZone);
    finding.source = blockRef(path, at.event.source, texts);
    // The motion up to the border follows, unless the tool stood there already.
    const Motion* motion = at.before < path.motions.size() ? &path.motions[at.before] : nullptr;
    if (motion != nullptr && motion->source.file == at.event.source.file &&
        motion->source.line == at.event.source.line) {
      finding.motion = at.before;
      finding.tool = motion->tool;
      finding.where = motion->to;
    }
    finding.message = fmt::format("{} (alarm {} of the control)", zone->message, zone->alarm);
    findings.push_back(std::move(finding));
  }
}

FindingKind deviationFinding(const DeviationPatch& patch) {
  return patch.kind == DeviationKind::kGouge ? FindingKind::kGouge : FindingKind::kExcess;
}

void addDeviation(const DeviationPatch& patch, const Comparison& comparison, std::vector<Finding>& findings) {
  Finding finding = patchFinding(deviationFinding(patch), patch, comparison);
  finding.message = deviationText(patch, comparison);
  findings.push_back(std::move(finding));
}

const DeviationPatch* addUndecided(const Comparison& comparison, std::vector<Finding>& findings,
                                   double profile_mm) {
  const std::vector<DeviationPatch>& all = comparison.undecided;
  if (all.empty()) return nullptr;
  const auto most = [&](const DeviationPatch& p) { return p.depth_mm + p.bound_mm - p.allowed_mm; };
  const DeviationPatch& worst = *std::max_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return most(a) < most(b); });
  Finding finding = patchFinding(FindingKind::kUndecided, worst, comparison);
  finding.message = deviationText(worst, comparison) +
                    fmt::format("; this is good to {:.2g} mm and cannot be decided", worst.bound_mm);
  if (all.size() > 1) finding.message += fmt::format(", nor can {} other places", all.size() - 1);
  finding.message += remedyText(comparison, worst, profile_mm);
  findings.push_back(std::move(finding));
  return &worst;
}

void addCoarseNominal(const Comparison& comparison, std::vector<Finding>& findings) {
  constexpr double kNoted = 0.2;  // of the smaller tolerance
  const double least = std::min(comparison.gouge_tolerance_mm, comparison.excess_tolerance_mm);
  if (comparison.nominal_chord_mm <= kNoted * least) return;
  Finding finding(FindingKind::kCoarseNominal);
  finding.severity = comparison.nominal_chord_mm > least ? Severity::kWarning : Severity::kNote;
  finding.where = comparison.nominal_chord_at;
  finding.message = comparison.nominal_chord_in_doubt
                        ? fmt::format(
                              "the nominal has flats that may be meant or stand for a round, from which they "
                              "are up to {} mm "
                              "off; if so, export it with chords of {:.2g} mm",
                              figure(comparison.nominal_chord_mm), wantedChord(comparison))
                        : fmt::format(
                              "the nominal is coarse: its facets leave the curved faces that they stand for "
                              "by up to {} mm; "
                              "what lies between the two is no deviation; export it with chords of {:.2g} mm",
                              figure(comparison.nominal_chord_mm), wantedChord(comparison));
  findings.push_back(std::move(finding));
}

void addIgnored(const std::vector<IgnoredRegion>& regions, const Comparison& comparison,
                std::vector<Finding>& findings) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    Finding finding(FindingKind::kNotCompared);
    finding.area_mm2 = comparison.ignored_mm2[i];
    finding.message =
        fmt::format("region '{}', {} mm2 of the part's surface, is not compared with the nominal",
                    regions[i].name, figure(comparison.ignored_mm2[i]));
    findings.push_back(std::move(finding));
  }
}

void addOutcome(double initial_mm3, double final_mm3, const std::vector<StockBody>& bodies,
                std::vector<Finding>& findings) {
  if (bodies.empty()) {
    Finding finding(FindingKind::kNoPart);
    finding.message = "nothing of the blank is left; check its place, the offsets and the tools";
    findings.push_back(std::move(finding));
    return;
  }
  if (initial_mm3 - final_mm3 <= kNothingCut * initial_mm3) {
    Finding finding(FindingKind::kNothingCut);
    finding.message = "the program cuts nothing; check the place of the blank and the offsets";
    findings.push_back(std::move(finding));
  }
  if (bodies.size() < 2) return;
  double loose_mm3 = 0;
  for (std::size_t i = 1; i < bodies.size(); ++i) loose_mm3 += bodies[i].volume_mm3;
  Finding finding(FindingKind::kLoosePiece);
  finding.where = bodies[1].bounds.center();
  finding.volume_mm3 = loose_mm3;
  finding.message = fmt::format("the stock is in {} pieces: {:.4g} mm3 are not held by the largest",
                                bodies.size(), loose_mm3);
  findings.push_back(std::move(finding));
}

void addUncertainPart(const std::vector<StockBody>& bodies, std::optional<std::size_t> rival,
                      std::vector<Finding>& findings) {
  if (!rival) return;
  const StockBody &part = bodies.front(), &other = bodies[*rival];
  Finding finding(FindingKind::kUncertainPart);
  finding.where = other.bounds.center();
  finding.volume_mm3 = other.volume_mm3;
  finding.message = fmt::format(
      "which body is the part is not said: taken is the one of {:.6g} mm3, Z{:.3f} to Z{:.3f}, beside one of "
      "{:.6g} "
      "mm3, Z{:.3f} to Z{:.3f}; give part_point in [stock], or a nominal",
      part.volume_mm3, part.bounds.min.z(), part.bounds.max.z(), other.volume_mm3, other.bounds.min.z(),
      other.bounds.max.z());
  findings.push_back(std::move(finding));
}

void addGridVolume(double own_mm3, double held_mm3, double resolution_mm, std::vector<Finding>& findings) {
  const double off_mm3 = held_mm3 - own_mm3;
  if (std::abs(off_mm3) <= kHeldShare * own_mm3) return;
  Finding finding(FindingKind::kThinFeature);
  finding.volume_mm3 = std::abs(off_mm3);
  finding.message = fmt::format(
      "the grid of {:g} mm holds {:.5g} mm3 of what is clamped, which has {:.5g} mm3: it is too thin for the "
      "grid "
      "somewhere, and volumes are off by as much; take a finer resolution",
      resolution_mm, held_mm3, own_mm3);
  findings.push_back(std::move(finding));
}

void addVolumeError(double removed_mm3, double error_mm3, double resolution_mm,
                    std::vector<Finding>& findings) {
  if (error_mm3 <= kErrorShare * removed_mm3) return;
  Finding finding(FindingKind::kThinFeature);
  finding.volume_mm3 = error_mm3;
  finding.message = fmt::format(
      "the grid of {:g} mm is coarse for what was cut: the removed volume of {:.4g} mm3 may be off by {:.2g} "
      "mm3; take a finer resolution",
      resolution_mm, removed_mm3, error_mm3);
  findings.push_back(std::move(finding));
}

void addThinFeatures(const RemovalSummary& removal, const StockSurface& surface, double resolution_mm,
                     const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings) {
  Finding finding(FindingKind::kThinFeature);
  if (removal.lost_film_mm2 > 0) {
    finding.where = removal.lost_film_at;
    finding.area_mm2 = removal.lost_film_mm2;
    finding.message = fmt::format(
        "about {:.3g} mm2 of stock are left thinner than the grid of {:g} mm and are not in the mesh; take a "
        "finer "
        "resolution",
        removal.lost_film_mm2, resolution_mm);
    findings.push_back(finding);
  }
  for (const NarrowCut& cut : removal.narrow_cuts) {
    Finding narrow = finding;
    narrow.where = cut.where;
    narrow.area_mm2 = cut.area_mm2;
    blame(narrow, cut.motion, path, texts);
    narrow.message = fmt::format(
        "cuts {:.2g} mm wide, over {:.3g} mm of path, pass between the samples of the grid of {:g} mm and "
        "are not in the "
        "mesh; --resolution {:.2g} could hold them",
        cut.width_mm, cut.length_mm, resolution_mm, cut.width_mm / kCellsInAWidth);
    findings.push_back(std::move(narrow));
  }
  if (surface.facets.mm > kNotableOff * resolution_mm) {
    finding.where = surface.facets.where;
    finding.area_mm2 = static_cast<double>(surface.thin_cells) * resolution_mm * resolution_mm;
    finding.message = fmt::format(
        "a wall, gap, ridge or edge is thinner or rounder than the grid of {:g} mm shows: the mesh may be up "
        "to {:.2g} "
        "mm off there{}; take a finer resolution",
        resolution_mm, surface.facets.mm,
        surface.thin_cells > 0 ? fmt::format(", in {} cells by much of a cell", surface.thin_cells) : "");
    findings.push_back(finding);
  }
}

void addPartial(ProgramEnd end, const ControlSettings& settings, std::vector<Finding>& findings) {
  if (end != ProgramEnd::kUntil) return;
  Finding finding(FindingKind::kPartial);
  finding.message =
      fmt::format("only the program up to {} was run: what follows was not checked", untilText(settings));
  findings.push_back(std::move(finding));
}

void addUnrunSetups(const std::string& last_name, std::vector<Finding>& findings) {
  Finding finding(FindingKind::kPartial);
  finding.setup = last_name;
  finding.message = fmt::format(
      "only the setups up to '{}' were run: what follows was not checked, nor the part against its nominal",
      last_name);
  findings.push_back(std::move(finding));
}

std::string untilText(const ControlSettings& settings) {
  if (!settings.until) return {};
  if (settings.until->block) return fmt::format("N{}", *settings.until->block);
  return fmt::format("line {}", settings.until->line.value_or(0));
}

void addFreedDefects(std::size_t pairs, std::vector<Finding>& findings) {
  addMeetings(pairs, "the freed pieces'", findings);
}

void addMeshDefects(const MeshTopology& topology, const StockSurface& surface,
                    std::vector<Finding>& findings) {
  addMeetings(surface.self_intersections, "the mesh's", findings);
  if (topology.closedManifold()) return;
  Finding finding(FindingKind::kMesh);
  finding.where = topology.first_defect;
  finding.message = fmt::format(
      "the mesh is not closed and 2-manifold: {} border edges, {} edges with more than two faces, {} "
      "misoriented, {} "
      "vertices with more than one fan, {} degenerate triangles",
      topology.boundary_edges, topology.non_manifold_edges, topology.misoriented_edges,
      topology.non_manifold_vertices, topology.degenerate_triangles);
  findings.push_back(std::move(finding));
}

namespace {

std::string blockText(const BlockRef& block) {
  return fmt::format("{}{}{}", report_text::place(block), block.text.empty() ? "" : ": ", block.text);
}

}  // namespace

Diagnostic findingDiagnostic(const Finding& finding) {
  Diagnostic diagnostic;
  diagnostic.severity = finding.severity;
  diagnostic.code = findingKindName(finding.kind);
  diagnostic.message = finding.message;
  if (finding.source) {
    diagnostic.where = {finding.source->file, static_cast<int>(finding.source->line), 0, 0};
    diagnostic.source_line = finding.source->text;
  }
  if (finding.known) {  // whoever knows it needs no more than to see it again
    diagnostic.severity = Severity::kNote;
    diagnostic.message = fmt::format("known {}: {}", severityName(finding.severity), finding.message);
  }
  if (!finding.worse.empty()) diagnostic.notes.push_back("worse than known: " + finding.worse);
  std::string place;
  if (finding.where) place = "at " + placeText(*finding.where);
  if (finding.tool) place += fmt::format("{}tool {}", place.empty() ? "" : ", ", *finding.tool);
  if (!finding.setup.empty()) place += fmt::format("{}setup {}", place.empty() ? "" : ", ", finding.setup);
  if (!place.empty()) diagnostic.notes.push_back(place);
  if (finding.inside) diagnostic.notes.push_back("moved by " + blockText(*finding.inside));
  if (finding.last_source) diagnostic.notes.push_back("the last one: " + blockText(*finding.last_source));
  constexpr std::size_t kBlocks = 4, kCauses = 3;
  if (finding.blocks.size() > 1)
    diagnostic.notes.push_back("made by " + report_text::blocksLine(finding, kBlocks));
  for (std::size_t i = 0; i < std::min(kCauses, finding.causes.size()); ++i)
    diagnostic.notes.push_back(report_text::causeNote(finding.causes[i]));
  if (finding.untried_causes > 0) diagnostic.notes.push_back(report_text::untriedNote(finding));
  return diagnostic;
}

}  // namespace proveout

// Cutter compensation: blocks go into the look-ahead, pieces come out and become motions.
#include "core/nc/iso/stages/comp_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tool/tip.h"

namespace proveout::nc {
namespace {

std::string describe(CompError error) {
  switch (error) {
    case CompError::kStartInArc:
      return "G41, G42 cannot be switched on in a G2 or G3 block";
    case CompError::kCancelInArc:
      return "G40 in circular interpolation";
    case CompError::kNoIntersection:
      return "no intersection point G41, G42: the tool does not fit into the inner corner";
    case CompError::kInterference:
      return "interference error: the compensated path runs against the programmed one";
    case CompError::kBufferFull:
      return "cutter compensation cannot be continued, buffer full: too many blocks without motion in the "
             "plane";
    case CompError::kSideChange:
      return "the change of side G41, G42 has no solution here";
    case CompError::kCornerArcInside:
      return "G39 on an inner corner";
    case CompError::kNotActive:
      return "G38 and G39 need G41 or G42";
    case CompError::kNotFinite:
    case CompError::kNone:
      break;
  }
  return "cutter compensation: data out of range";
}

DiagnosticName nameOf(CompError error) {
  switch (error) {
    case CompError::kCancelInArc:
      return SharedAlarm::kCompEndInArc;
    case CompError::kNoIntersection:
      return SharedAlarm::kCompNoIntersection;
    case CompError::kInterference:
      return SharedAlarm::kCompInterference;
    case CompError::kBufferFull:
      return SharedAlarm::kCompBuffer;
    default:
      return "cutter-comp";
  }
}

std::string describe(CompWarning warning) {
  switch (warning) {
    case CompWarning::kRepaired:
      return "interference in cutter compensation: this block is left out of the path";
    case CompWarning::kNearTangent:
      return "nearly tangent inner corner without intersection: joined by a short line";
    case CompWarning::kManyPassThrough:
      return "more blocks without motion in the plane than the control promises to look over";
  }
  return {};
}

/// Arcs about one point have the same centre but for rounding, mm; those about corners have others.
constexpr double kSameCentre = 1e-6;

/// Part of the feed on an arc that cutter compensation has made smaller (manual 6.4): 1 where it has not.
double insideArcFactor(const IsoParameters& parameters, double programmed_radius, double radius) {
  if (!(radius < programmed_radius)) return 1.0;
  return std::max(radius / programmed_radius, parameters[FeedParam::kInsideArcLeast]);
}

}  // namespace

void CompStage::engage(const Vec3& start, void (*maker)(const IsoParameters&, CutterCompPolicy&)) {
  CutterCompPolicy policy;
  policy.interference_check = parameters_.flag(CompParam::kInterferenceCheck);
  policy.interference_alarm = parameters_.flag(CompParam::kInterferenceAlarm);
  policy.extra_look_ahead = static_cast<int>(parameters_[CompParam::kExtraLookAhead]);
  policy.min_step = parameters_[CompParam::kMinCompStep];
  if (maker != nullptr) maker(parameters_, policy);
  tip_ = Vec2::Zero();
  begin(policy, start);
}

void CompStage::report(Severity severity, const DiagnosticName& code, const std::string& message,
                       std::uint64_t tag) {
  const PathItem* item = waiting(tag);
  if (item != nullptr) return alarms_.sendLate(severity, code, message, item->source, item->record);
  if (severity == Severity::kError) {
    alarms_.fail(code, message);
  } else {
    alarms_.warn(code, message);
  }
}

void CompStage::note(const CompNote& told) {
  report(Severity::kWarning, "cutter-comp", describe(told.warning), told.tag);
}

void CompStage::failed(const CompStatus& status) {
  // The name of our own is the usual one of compensation where the control has no number for it.
  const bool numbered = alarms_.table().number(SharedAlarm::kCompStartInArc) != 0;
  const DiagnosticName name = status.error == CompError::kStartInArc && numbered
                                  ? DiagnosticName(SharedAlarm::kCompStartInArc)
                                  : nameOf(status.error);
  report(Severity::kError, name, describe(status.error), status.tag);
  recovery_.recover();
}

bool CompStage::send(const CompPiece& piece, const PathItem& item, PathItem& out) {
  const bool concentric = piece.is_arc && (out.center - item.center).head<2>().norm() < kSameCentre;
  if (item.kind == PathItem::Kind::kArc && concentric) {
    const Vec3 programmed = item.plane.of(item.to) - item.center;
    const Vec3 corrected = piece.to - out.center;
    out.feed.feed *= insideArcFactor(parameters_, programmed.head<2>().norm(), corrected.head<2>().norm());
  }
  if (out.feed.join.inside != 0) out.feed.join.inside = item.offset < 0.0 ? -1 : 1;
  return toTip(piece, item, out) && pass(out);
}

/// Codes count with the first and second axis of the plane as Z and X of a lathe (digest nct-3, Q17).
bool CompStage::toTip(const CompPiece& piece, const PathItem& item, PathItem& out) {
  const Vec2 direction = item.comp_on ? tipDirection(item.tip) : Vec2(Vec2::Zero());
  const Vec2 tip = std::abs(item.offset) * Vec2(direction.y(), direction.x());
  const Vec2 before = std::exchange(tip_, tip);
  if (piece.is_arc && (before - tip).norm() > kSameCentre) {
    report(Severity::kError, "cutter-comp", "the tip code Q of D may not change in an arc", item.tag);
    recovery_.recover();
    return false;
  }
  out.to[item.plane.u] += tip.x();
  out.to[item.plane.v] += tip.y();
  if (!piece.is_arc) return true;
  out.center.head<2>() += tip;
  out.start += tip;
  return true;
}

}  // namespace proveout::nc

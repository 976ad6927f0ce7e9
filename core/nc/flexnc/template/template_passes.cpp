#include "core/nc/flexnc/template/template_passes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/flexnc/cycles/cycle_checks.h"
#include "core/nc/flexnc/cycles/cycle_moves.h"
#include "core/nc/services/contour/contour_profile.h"

namespace proveout::nc {

namespace {

using Role = CycleMove::Role;

constexpr double kSame = 1e-9;           ///< mm
constexpr double kSameDiameter = 0.001;  ///< mm; an increment that begins elsewhere is told

/// Radii of the passes before the last one along the profile: steps of P, and the junctions themselves.
std::vector<double> passLevels(const TemplateInput& in, const TemplateProfile& profile, double depth) {
  std::vector<double> levels;
  double before = profile.end().y();
  const auto stepTo = [&](double radius) {
    const double steps = stepsOver(in.side * (before - radius), depth) - 1.0;
    for (double i = 1.0; i <= steps; i += 1.0) levels.push_back(before - in.side * i * depth);
    before = radius;
  };
  for (const double junction : profile.junctions) {
    stepTo(junction);
    levels.push_back(junction);
  }
  stepTo(profile.start().y());
  return levels;
}

/// The part of the profile that lies behind the plane z.
PlaneContour behindPlane(const TemplateProfile& profile, double z) {
  if (profile.start().x() < z) return profile.elements;
  const ContourProfile along(profile.elements, 0, -1.0);
  const std::vector<ContourProfile::Zone> front = along.zonesBelow({0.0, along.length()}, -z);
  return front.empty() ? profile.elements : along.between(front.back().b, along.length());
}

void warnOfFront(const TemplateInput& in, const TemplateProfile& profile, double plane, CycleAnswer& answer) {
  if (!profile.before_face) return;
  answer.warnings.push_back(
      {"fnc-z-front",
       fmt::format("{}: the profile begins at Z{:.3f} in front of the face: it is cut from "
                   "Z{:.3f} on",
                   cycleName(in.row.code), profile.start().x(), std::min(profile.start().x(), plane))});
}

void cutLevels(const TemplateInput& in, const ContourProfile& profile, const std::vector<double>& levels,
               double plane, CycleMoves& moves, CycleAnswer& answer) {
  int left_out = 0;
  for (const double radius : levels) {
    const auto below = profile.zonesBelow({0.0, profile.length()}, profile.level(Vec2(0.0, radius)));
    const double z = profile.at(below.empty() ? 0.0 : below.back().b).x();
    if (z > plane - kSame) {
      ++left_out;
      continue;
    }
    moves.beginPass();
    moves.feedToR(radius, Role::kInfeed);
    moves.feedToZ(z, Role::kPass);
    moves.feedToR(radius + in.c / 5.0, Role::kRetract);
    moves.rapidToZ(plane, Role::kRetract);
  }
  if (left_out == 0) return;
  answer.warnings.push_back(
      {"fnc-z-front", fmt::format("{}: {} passes in front of the start point at Z{:.3f} are left out",
                                  cycleName(in.row.code), left_out, plane)});
}

/// From where the tool is onto the contour's diameter, to its start and along it.
void cutAlong(const PlaneContour& contour, CycleMoves& moves) {
  moves.feedToR(contour.front().from.y(), Role::kInfeed);
  moves.feedToZ(contour.front().from.x(), Role::kContour);
  for (const ContourElement& e : contour) moves.along(e);
}

}  // namespace

void roughTemplate(const CycleCall& call, const TemplateInput& in, const TemplateProfile& profile,
                   CycleAnswer& answer) {
  const double depth = call.arguments.value('P'), plane = call.arguments.value('B') - in.v;
  const double thickness = in.side * (profile.end().y() - profile.start().y());
  answer.alarm = checkPasses(in.row.code, thickness / depth, "P");
  if (answer.alarm) return;
  warnOfFront(in, profile, plane, answer);
  const double start_radius = profile.end().y() + in.c;
  CycleMoves moves(call.at);
  moves.rapidTo(Vec2(plane, start_radius), Role::kApproach);
  cutLevels(in, ContourProfile(profile.elements, 1, in.side), passLevels(in, profile, depth), plane, moves,
            answer);
  moves.beginPass();
  cutAlong(behindPlane(profile, plane), moves);
  answer.passes = moves.pass();
  moves.endPass();
  if (in.side > 0.0) moves.rapidToR(start_radius, Role::kReturn);
  moves.rapidToZ(plane, Role::kReturn);
  answer.moves = moves.take();
}

namespace {

/// Beyond the diameter that the contour begins at an approach would run along the face through the part.
std::optional<CycleNote> checkApproach(const CycleCall& call, const TemplateInput& in, const Vec2& start) {
  if (in.side * (call.at.y() - start.y()) <= kSame) return std::nullopt;
  return CycleNote{
      "fnc-equi-x",
      fmt::format(
          "the approach to {} stands at X{:.3f}, {} the diameter {:.3f} where its contour begins: X of "
          "G81.{} {}",
          cycleName(in.row.code), 2.0 * call.at.y(), in.side > 0.0 ? "above" : "below", 2.0 * start.y(),
          in.side > 0.0 ? "1" : "2", in.side > 0.0 ? "smaller" : "larger")};
}

/// K=1. False: an alarm was given.
bool beginChain(const CycleCall& call, const TemplateInput& in, const TemplateProfile& profile,
                CycleMoves& moves, CycleAnswer& answer) {
  const double plane = call.approached ? -in.v : call.arguments.value('B') - in.v;
  const PlaneContour contour = behindPlane(profile, plane);
  const Vec2 start = contour.front().from;
  warnOfFront(in, profile, plane, answer);
  answer.chain = ContourChain{call.approached, plane};
  if (call.approached) {
    answer.alarm = checkApproach(call, in, start);
    if (answer.alarm) return false;
    moves.feedTo(Vec2(plane, start.y()), Role::kApproach);
  } else {
    moves.rapidTo(Vec2(plane, start.y() + in.c), Role::kApproach);
  }
  moves.beginPass();
  cutAlong(contour, moves);
  return true;
}

/// K=0. False: an alarm was given.
bool continueChain(const CycleCall& call, const TemplateInput& in, const TemplateProfile& profile,
                   CycleMoves& moves, CycleAnswer& answer) {
  const std::string name = cycleName(in.row.code);
  if (!call.chain) {
    answer.alarm =
        CycleNote{"fnc-k", name + ": K0 goes on with a contour block before it, and there is none: K1"};
    return false;
  }
  answer.chain = call.chain;
  const double starts = 2.0 * profile.start().y(), stands = 2.0 * call.at.y();
  if (std::abs(starts - stands) > kSameDiameter) {
    answer.warnings.push_back(
        {"fnc-k", fmt::format("{}: its contour begins at diameter {:.3f}, the one before ends at {:.3f}: K0 "
                              "runs it in increments from there",
                              name, starts, stands)});
  }
  moves.beginPass();
  moves.feedToZ(call.at.x() + std::min(profile.start().x() + in.v, 0.0), Role::kContour);
  for (const ContourElement& e : profile.elements) moves.along(e);
  return true;
}

/// Due where the chain ends.
std::vector<CycleMove> chainReturn(const TemplateInput& in, const ContourChain& chain, const Vec2& from) {
  CycleMoves moves(from);
  if (chain.approached) return moves.take();
  if (in.side > 0.0) moves.rapidToR(from.y() + in.c, Role::kReturn);
  moves.rapidToZ(chain.start_z, Role::kReturn);
  return moves.take();
}

}  // namespace

void cutTemplateContour(const CycleCall& call, const TemplateInput& in, const TemplateProfile& profile,
                        bool goes_on, CycleAnswer& answer) {
  CycleMoves moves(call.at);
  const bool good = goes_on ? continueChain(call, in, profile, moves, answer)
                            : beginChain(call, in, profile, moves, answer);
  if (!good) return;
  answer.passes = moves.pass();
  answer.chain_return = chainReturn(in, *answer.chain, moves.at());
  answer.moves = moves.take();
}

}  // namespace proveout::nc

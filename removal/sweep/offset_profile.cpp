#include "removal/sweep/offset_profile.h"

#include <cmath>

namespace proveout {
namespace {

using Element = ConvexProfile::Element;

bool looksDown(const Element& e) { return e.arc ? e.az < e.cz : e.dr > 0.0; }
bool isUpright(const Element& e) { return !e.arc && e.dr == 0.0; }
bool isLevel(const Element& e) { return !e.arc && e.dz == 0.0; }

/// Flanks are upright to the last bit: radii that rounding tells apart are one.
constexpr double kOneRadiusMm = 1e-9;

/// Goes on to a place, on a flank where that is the same radius as `r`, mm; which becomes that of the place.
void goTo(ConvexProfile& profile, double& r, double to_r, double to_z) {
  if (std::abs(to_r - r) > kOneRadiusMm) r = to_r;
  profile.lineTo(r, to_z);
}

ConvexProfile cylinderAround(const ConvexProfile& profile, double level, double upright) {
  ConvexProfile grown;
  const double r = profile.maxRadius() + level;
  grown.start(0.0, profile.zMin() - upright);
  grown.lineTo(r, profile.zMin() - upright);
  grown.lineTo(r, profile.zMax() + upright);
  grown.lineTo(0.0, profile.zMax() + upright);
  return grown;
}

}  // namespace

ConvexProfile offsetProfile(const ConvexProfile& profile, double level, double upright) {
  // Up to two more: a disc where an end is pointed or round, and the flank.
  if (profile.elementCount() + 3 > ConvexProfile::kMaxElements)
    return cylinderAround(profile, level, upright);
  ConvexProfile grown;
  grown.start(0.0, profile.zMin() - upright);
  double r = 0.0;
  for (int i = 0; i < profile.elementCount(); ++i) {
    const Element& e = profile.element(i);
    if (isUpright(e)) continue;  // what comes next sets out from its end
    const double up = looksDown(e) ? -upright : upright;
    if (!isLevel(e) || !looksDown(e) || e.ar > 0.0) goTo(grown, r, e.ar + level, e.az + up);
    if (e.arc) {
      r = e.br + level;
      grown.arcTo(e.cr + level, e.cz + up, r, e.bz + up);
    } else {
      goTo(grown, r, isLevel(e) && e.br == 0.0 ? 0.0 : e.br + level, e.bz + up);
    }
  }
  goTo(grown, r, 0.0, profile.zMax() + upright);
  return grown;
}

}  // namespace proveout

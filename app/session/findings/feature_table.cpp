#include "app/session/findings/feature_table.h"

namespace proveout {
namespace {

/// Less than half of a face is there: what is left of it says nothing of its size.
bool isGone(const FaceFit& fit) { return fit.missed > fit.points; }

void addRound(const CadFace& face, const FaceFit& fit, ReportFeature& out) {
  if (face.isWholeCylinder()) {
    out.characteristics.push_back({"diameter", 2.0 * face.radius, 2.0 * fit.radius_mm});
  } else {
    out.characteristics.push_back({"radius", face.radius, fit.radius_mm});
  }
  // True position: the diameter of the zone around the model's place (ISO 1101).
  if (fit.placed) out.characteristics.push_back({"position", 0.0, 2.0 * fit.shift.norm()});
  out.characteristics.push_back({"roundness", 0.0, fit.form_mm});
}

ReportFeature featureOf(const CadFace& face, const FaceFit& fit) {
  ReportFeature out;
  out.feature = describe(face);
  out.missing = isGone(fit);
  if (out.missing) return out;
  switch (face.kind) {
    case SurfaceKind::kCylinder:
    case SurfaceKind::kSphere:
      addRound(face, fit, out);
      break;
    case SurfaceKind::kPlane:
      out.characteristics.push_back({"height", 0.0, fit.mean_mm});
      out.characteristics.push_back({"flatness", 0.0, fit.form_mm});
      break;
    default:
      out.characteristics.push_back({"lowest", 0.0, fit.least_mm});
      out.characteristics.push_back({"highest", 0.0, fit.most_mm});
      break;
  }
  return out;
}

}  // namespace

std::vector<ReportFeature> featureTable(const Comparison& comparison) {
  std::vector<ReportFeature> out;
  for (const FaceFit& fit : comparison.face_fits)
    out.push_back(featureOf(comparison.nominal_faces->faces[fit.face], fit));
  return out;
}

}  // namespace proveout

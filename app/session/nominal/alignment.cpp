#include "app/session/nominal/alignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "io/report_text.h"
#include "removal/compare/deepest_point.h"
#include "removal/compare/fit/datums.h"
#include "removal/compare/fit/fit.h"
#include "removal/compare/fit/model_frame.h"

namespace proveout {

namespace {

using report_text::figure;

void moveNominal(const RigidTransform& motion, PreparedMesh& nominal) {
  moveMesh(motion, nominal.mesh);
  if (nominal.faces == nullptr) return;
  CadFaces faces = *nominal.faces;
  const MeshPlacement placement = placementOf(motion);
  for (CadFace& face : faces.faces) face = face.placed(placement);
  nominal.faces = std::make_shared<const CadFaces>(std::move(faces));
}

/// A limit that would do, with few digits.
double roomyLimit(double moved_mm) {
  const double digit = std::pow(10.0, std::floor(std::log10(moved_mm)) - 1.0);
  return std::ceil(1.05 * moved_mm / digit) * digit;
}

std::string tooFar(const Alignment& found, double limit_mm) {
  const Vec3& by = found.motion.translation;
  return fmt::format(
      "the nominal is not aligned and not compared: that would move it by up to {} mm (X{:.3f} Y{:.3f} "
      "Z{:.3f} at the "
      "origin, turned by {} degrees), and no more than {:g} mm is allowed; check where it lies (move and "
      "rotate under "
      "[nominal], --nominal-at), or enter align_limit = {:g} (--align-limit)",
      figure(found.moved_mm), by.x(), by.y(), by.z(), figure(radToDeg(found.turned_rad)), limit_mm,
      roomyLimit(found.moved_mm));
}

/// Takes what was found, if it is allowed. Errors: what is not an input's.
Result<AlignOutcome> taken(const Result<Alignment>& found, double limit_mm, PreparedMesh& nominal) {
  AlignOutcome out;
  if (!found) {
    if (found.error().kind != ErrorKind::kInput) return found.error();
    out.fault = "the nominal is not aligned and not compared: " + found.error().message +
                "; check its unit, its place and its axes (unit, scale, rotate and move under [nominal])";
    return out;
  }
  if (found->moved_mm > limit_mm) {
    out.fault = tooFar(*found, limit_mm);
    return out;
  }
  moveNominal(found->motion, nominal);
  out.alignment = *found;
  return out;
}

}  // namespace

void measureAligned(const PreparedMesh& nominal, const Alignment& alignment, const AlignedPart& part,
                    double spacing_mm, Comparison& comparison) {
  const auto measure = [&](const ExactPart& exact) {
    measureInModelFrame(nominal.mesh, *nominal.faces, alignment.motion, exact, spacing_mm, comparison);
  };
  if (part.exact != nullptr) return measure(*part.exact);
  const SurfaceMesh surface = toSurface(part.mesh);
  const SignedDistance distance(surface, 0.5 * spacing_mm);
  measure(MeshPart(distance, part.uncertainty_mm));
}

void placeOnPart(const RigidTransform& motion, std::size_t first, std::vector<Finding>& findings) {
  for (std::size_t k = first; k < findings.size(); ++k) {
    if (findings[k].where) findings[k].where = motion(*findings[k].where);
  }
}

Status checkAlignment(const NominalSpec& spec, const CadFaces* faces) {
  if (spec.align.kind != AlignKind::kDatums || faces != nullptr) return Done{};
  return inputError(
      spec.mesh.path +
      ": align = \"datums\" needs a STEP file: the faces of a mesh are not known; align = \"fit\" "
      "goes by the surface");
}

Result<AlignOutcome> alignNominal(const NominalSpec& spec, const AlignedPart& part, PreparedMesh& nominal,
                                  Progress& progress) {
  const AlignWish& wish = spec.align;
  if (const Status known = checkAlignment(spec, nominal.faces.get()); !known) return known.error();
  progress.report("aligning", 0.0);
  if (wish.kind == AlignKind::kFit) {
    constexpr std::size_t kPoints = 40'000;
    const double reach_mm = 2.0 * part.uncertainty_mm + 0.01;
    const FitPoints points = fitPointsOf(part.mesh, part.exact, reach_mm, spec.ignored, kPoints);
    return taken(fitNominal(nominal.mesh, nominal.faces.get(), points, wish.limit_mm, progress),
                 wish.limit_mm, nominal);
  }
  if (part.exact != nullptr)
    return taken(alignByDatums(nominal.mesh, *nominal.faces, wish.datums, *part.exact), wish.limit_mm,
                 nominal);
  const SurfaceMesh surface = toSurface(part.mesh);
  const SignedDistance distance(surface, 0.1);
  return taken(
      alignByDatums(nominal.mesh, *nominal.faces, wish.datums, MeshPart(distance, part.uncertainty_mm)),
      wish.limit_mm, nominal);
}

Result<AlignOutcome> alignToScan(const NominalSpec& spec, const std::vector<Vec3>& points,
                                 PreparedMesh& nominal, Progress& progress) {
  if (spec.align.kind == AlignKind::kDatums)
    return inputError("--align datums needs a closed part: a scan is aligned by --align fit");
  progress.report("aligning", 0.0);
  FitPoints fit;
  fit.points = points;
  std::erase_if(fit.points, [&](const Vec3& p) {
    return std::any_of(spec.ignored.begin(), spec.ignored.end(),
                       [&](const IgnoredRegion& r) { return r.contains(p); });
  });
  return taken(fitNominal(nominal.mesh, nominal.faces.get(), fit, spec.align.limit_mm, progress),
               spec.align.limit_mm, nominal);
}

ReportAlignment reportAlignment(const Alignment& alignment) {
  ReportAlignment out;
  out.kind = alignment.kind == AlignKind::kDatums ? "datums" : "fit";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      out.matrix[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          alignment.motion.rotation(row, column);
    out.matrix[static_cast<std::size_t>(row)][3] = alignment.motion.translation[row];
  }
  out.rms_mm = alignment.rms_mm;
  out.moved_mm = alignment.moved_mm;
  out.turned_deg = radToDeg(alignment.turned_rad);
  out.points = alignment.points;
  out.left_out = alignment.left_out;
  out.free_directions = alignment.free_directions;
  return out;
}

}  // namespace proveout

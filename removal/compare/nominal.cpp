#include "removal/compare/nominal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/place_text.h"
#include "core/mesh/edge_table.h"
#include "removal/compare/cracks.h"
#include "removal/compare/join_bodies.h"
#include "removal/compare/self_crossing.h"
#include "removal/compare/shell_sides.h"
#include "removal/compare/stray_facets.h"

namespace proveout {

namespace {

/// The range of the job's own lengths, 1 km: beyond it a float is good to 0.06 mm at best.
constexpr double kLargestMm = 1e6;

}  // namespace

std::optional<Error> findBadElements(const TriMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) return inputError(name + ": the mesh has no triangles");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].allFinite()) continue;
    return inputError(
        fmt::format("{}: vertex {} is not a finite number; export the mesh again", name, i + 1));
  }
  const Box3 box = meshBounds(mesh);
  const double most = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
  if (most > kLargestMm) {
    return inputError(
        fmt::format("{}: the mesh reaches as far as {:.4g} mm, and coordinates go up to {:g} mm: "
                    "is its unit right?",
                    name, most, kLargestMm));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (triangleIsProper(mesh.triangles[i], mesh.positions.size())) continue;
    return inputError(fmt::format(
        "{}: triangle {} names a vertex twice or one that is not there; export the mesh again", name, i + 1));
  }
  if (!mesh.motion.empty() && mesh.motion.size() != mesh.triangles.size()) {
    return Error{ErrorKind::kInternal, name + ": one motion per triangle is needed, or none"};
  }
  return std::nullopt;
}

OpenEdges findOpenEdges(const TriMesh& mesh) {
  OpenEdges out;
  Vec3 first_opposed = Vec3::Zero();
  const EdgeTable edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge([&](std::uint32_t low, const HalfEdge* first, const HalfEdge* last) {
    std::ptrdiff_t balance = 0;
    for (const HalfEdge* h = first; h < last; ++h) {
      balance += mesh.triangles[h->half_edge / 3][h->half_edge % 3] == low ? 1 : -1;
    }
    if (balance == 0) return;
    const Vec3 middle = 0.5 * (mesh.positions[low] + mesh.positions[first->other]).cast<double>();
    if ((last - first) % 2 != 0) {
      if (out.odd++ == 0) out.first = middle;
    } else if (out.opposed++ == 0) {
      first_opposed = middle;
    }
  });
  if (out.odd == 0) out.first = first_opposed;
  return out;
}

namespace {

Error openError(const BorderGaps& gaps, const OpenEdges& open, const std::string& name) {
  std::string what = crackText(gaps);
  if (!gaps.onlyCracks()) {
    const Vec3& at = gaps.hole_edges > 0 ? gaps.first_hole : open.first;
    what = fmt::format("a hole or a wall without thickness at {} mm", placeText(at));
    if (gaps.crack_edges > 0) what += ", and " + crackText(gaps);
  }
  return inputError(fmt::format(
      "{}: the mesh is not closed: {} ({} open edges in all); repair it in the CAD system, or export it "
      "again as a closed solid",
      name, what, open.odd));
}

/// Closes cracks that are far narrower than any tolerance, or refuses the mesh.
Status closeMesh(TriMesh& mesh, const std::string& name, std::vector<std::string>& notes) {
  // Rounding of the coordinates, and what a crack may have before its borders have to be joined by hand.
  constexpr double kRoundingMm = 1e-4, kRoundingPart = 1e-6, kClosedMm = 1e-3;
  const OpenEdges open = findOpenEdges(mesh);
  if (open.odd == 0) return Done{};
  const BorderGaps gaps = findBorderGaps(mesh);
  const double rounding = kRoundingMm + kRoundingPart * meshBounds(mesh).size().norm();
  std::vector<double> reaches = {rounding};
  // Corners that were moved on their own are farther apart than borders.
  if (gaps.width_mm <= kClosedMm && 2.0 * gaps.width_mm > rounding) reaches.push_back(2.0 * gaps.width_mm);
  for (const double reach : reaches) {
    TriMesh closed = mesh;
    const CrackRepair repair = closeCracks(closed, reach);
    if (closed.triangles.empty() || findOpenEdges(closed).odd > 0) continue;
    mesh = std::move(closed);
    std::string how = fmt::format("{} border vertices merged", repair.merged);
    if (repair.split > 0)
      how += fmt::format(", {} facets split at corners of others on their edges", repair.split);
    notes.push_back(fmt::format("{}: the mesh was not closed: {}; closed ({})", name, crackText(gaps), how));
    return Done{};
  }
  return openError(gaps, open, name);
}

/// Makes neighbours agree. Returns what makeConsistent has as doubtful, or nothing where all agreed.
Result<std::vector<char>> agreeAll(TriMesh& mesh, const std::string& name, std::vector<std::string>& notes) {
  const OpenEdges open = findOpenEdges(mesh);
  if (open.opposed == 0) return std::vector<char>();
  std::optional<TurnedFacets> turned = makeConsistent(mesh);
  if (!turned || findOpenEdges(mesh).opposed > 0) {
    return inputError(
        fmt::format("{}: facets disagree about which side is outside at {} mm and cannot be turned to "
                    "agree; export the mesh again as a closed solid",
                    name, placeText(open.first)));
  }
  notes.push_back(fmt::format("{}: facets had mixed orientation; made consistent", name));
  return std::move(turned->doubtful);
}

/// Refuses what crosses itself by more than a small part of any tolerance, and tells the rest.
Status checkCrossings(const Shells& shells, const std::string& name, std::vector<std::string>& notes) {
  constexpr double kMostMm = 0.01;
  const SelfCrossing crossing = findSelfCrossing(shells);
  if (crossing.pairs == 0) return Done{};
  const std::string what =
      fmt::format("{}: the surface crosses itself at {} mm, {:.2g} mm deep ({} pairs of facets in all)", name,
                  placeText(crossing.where), crossing.depth_mm, crossing.pairs);
  if (crossing.depth_mm > kMostMm)
    return inputError(what + "; repair it in the CAD system, or export it again with finer facets");
  notes.push_back(what);
  return Done{};
}

void noteTurned(const TurnedShells& turned, const std::string& name, std::vector<std::string>& notes) {
  if (turned.turned > 0) {
    notes.push_back(
        fmt::format("{}: {} inside out; turned", name,
                    turned.turned == 1 ? "a shell was" : fmt::format("{} shells were", turned.turned)));
  }
  if (turned.within > 0) {
    notes.push_back(
        fmt::format("{}: {} within the material of another, at {} mm: taken as solid and one with it (the "
                    "facets of a void would face inwards)",
                    name, turned.within == 1 ? "a body lies" : fmt::format("{} bodies lie", turned.within),
                    placeText(turned.first_within)));
  }
}

}  // namespace

Result<PreparedMesh> prepareNominal(const TriMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) return inputError(name + ": the mesh has no triangles");
  PreparedMesh out;
  out.mesh = weldVertices(mesh);
  if (auto bad = findBadElements(out.mesh, name)) return *bad;
  if (const std::size_t n = dropDoubledFacets(out.mesh); n > 0)
    out.notes.push_back(fmt::format("{}: dropped {} doubled triangles", name, n));
  if (findOpenEdges(out.mesh).odd > 0) dropFlatStrays(out.mesh);
  if (const Status closed = closeMesh(out.mesh, name, out.notes); !closed) return closed.error();
  if (out.mesh.triangles.empty()) return inputError(name + ": no triangle is left that bounds a solid");
  const Result<std::vector<char>> doubtful = agreeAll(out.mesh, name, out.notes);
  if (!doubtful) return doubtful.error();
  Shells shells = splitShells(out.mesh);
  const Result<TurnedShells> turned = orientShells(shells, *doubtful, name);
  if (!turned) return turned.error();
  noteTurned(*turned, name, out.notes);
  if (const Status sound = checkCrossings(shells, name, out.notes); !sound) return sound.error();
  Result<JoinedBodies> joined = joinBodies(shells, name);
  if (!joined) return joined.error();
  out.mesh = std::move(joined->mesh);
  if (joined->joined > 0) {
    out.notes.push_back(fmt::format("{}: {} bodies that touch or overlap were joined", name, joined->joined));
  }
  out.notes.insert(out.notes.end(), joined->notes.begin(), joined->notes.end());
  if (!(meshVolume(out.mesh) > 0.0)) return inputError(name + ": the mesh encloses no volume");
  return out;
}

}  // namespace proveout

#include "io/step/reader/step_facets.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <map>
#include <string>

#include "io/step/reader/step_bodies.h"

namespace proveout::step_reader {
namespace {

/// Facets of rounds turn by no more than this, rad, so that even small ones are round.
constexpr double kMostTurn = 0.25;
/// The chord that is asked for is exceeded by a quarter here and there.
constexpr double kMargin = 0.5;

enum Kind { kPlane, kCylinder, kCone, kSphere, kTorus, kOther };

std::array<double, 3> tripleOf(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }

/// A point in the middle of the face's parameters, and the normal there that points out of the material.
/// `turn`: how far the face goes along the first parameter.
void middleOf(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, gp_Pnt& at, gp_Vec& normal,
              double& turn) {
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  turn = u1 - u0;
  gp_Vec du, dv;
  // A little off the middle: not where a sphere or a torus has a special place.
  surface.D1(u0 + 0.47 * (u1 - u0), v0 + 0.47 * (v1 - v0), at, du, dv);
  normal = du.Crossed(dv);
  if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
}

FaceSurface surfaceOf(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face);
  FaceSurface out;
  gp_Pnt at;
  gp_Vec normal;
  double turn = 0.0;
  middleOf(face, surface, at, normal, turn);
  gp_XYZ origin, axis(0.0, 0.0, 1.0);
  const auto take = [&](int kind, const gp_Ax3& position, double radius) {
    out.kind = kind;
    origin = position.Location().XYZ();
    axis = position.Direction().XYZ();
    out.radius = radius;
  };
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      if (normal.Magnitude() == 0.0) return out;
      take(kPlane, surface.Plane().Position(), 0.0);
      axis = normal.Normalized().XYZ();
      break;
    case GeomAbs_Cylinder:
      take(kCylinder, surface.Cylinder().Position(), surface.Cylinder().Radius());
      break;
    case GeomAbs_Cone:
      take(kCone, surface.Cone().Position(), surface.Cone().RefRadius());
      out.half_angle_rad = surface.Cone().SemiAngle();
      if (out.half_angle_rad < 0.0) {  // towards the wide end
        axis.Reverse();
        out.half_angle_rad = -out.half_angle_rad;
      }
      break;
    case GeomAbs_Sphere:
      take(kSphere, surface.Sphere().Position(), surface.Sphere().Radius());
      break;
    case GeomAbs_Torus:
      take(kTorus, surface.Torus().Position(), surface.Torus().MajorRadius());
      out.tube_radius = surface.Torus().MinorRadius();
      break;
    default:
      return out;
  }
  out.origin = tripleOf(origin);
  out.axis = tripleOf(axis);
  if (out.kind == kPlane) return out;
  if (out.kind == kCylinder || out.kind == kCone) out.turn_rad = turn;
  const gp_XYZ from = at.XYZ() - origin;
  gp_XYZ outwards = from;  // of a sphere
  if (out.kind != kSphere) {
    const gp_XYZ across = from - axis * from.Dot(axis);
    const double length = across.Modulus();
    outwards = out.kind == kTorus && length > 0.0 ? from - across * (out.radius / length) : across;
    // Beyond the apex the distance from the axis grows the other way.
    if (out.kind == kCone && out.radius + from.Dot(axis) * std::tan(out.half_angle_rad) < 0.0)
      out.kind = kOther;
  }
  // A torus that goes through itself has two sheets.
  if (out.kind == kTorus && out.tube_radius >= out.radius) out.kind = kOther;
  out.hollow = normal.XYZ().Dot(outwards) < 0.0;
  return out;
}

/// The facets of face number `number` of `out`.
void addFace(std::size_t number, Facets& out) {
  const TopoDS_Face& face = out.faces[number];
  TopLoc_Location place;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
  if (mesh.IsNull() || mesh->NbTriangles() == 0) {
    throw Refusal{"face " + std::to_string(number + 1) +
                  " cannot be meshed: its borders do not close; repair the body in the CAD system"};
  }
  const auto first = static_cast<std::uint32_t>(out.vertices.size());
  for (int k = 1; k <= mesh->NbNodes(); ++k) {
    const gp_Pnt p = mesh->Node(k).Transformed(place.Transformation());
    out.vertices.push_back({static_cast<float>(p.X()), static_cast<float>(p.Y()), static_cast<float>(p.Z())});
  }
  const bool reversed = (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
  for (int k = 1; k <= mesh->NbTriangles(); ++k) {
    int a = 0, b = 0, c = 0;
    mesh->Triangle(k).Get(a, b, c);
    if (reversed) std::swap(b, c);
    const auto index = [&](int node) { return first + static_cast<std::uint32_t>(node - 1); };
    out.triangles.push_back({index(a), index(b), index(c)});
    out.face_of.push_back(static_cast<std::uint32_t>(number));
  }
}

}  // namespace

bool areClosed(const Facets& facets) {
  std::map<std::array<float, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> of(facets.vertices.size());
  for (std::size_t k = 0; k < of.size(); ++k)
    of[k] = known.emplace(facets.vertices[k], static_cast<std::uint32_t>(known.size())).first->second;
  std::vector<std::uint64_t> ways, back;
  double volume = 0.0;
  for (const auto& t : facets.triangles) {
    std::array<gp_XYZ, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<float, 3>& v = facets.vertices[t[k]];
      p[k] = gp_XYZ(v[0], v[1], v[2]);
      const std::uint64_t from = of[t[k]], to = of[t[(k + 1) % 3]];
      if (from == to) continue;
      ways.push_back(from << 32U | to);
      back.push_back(to << 32U | from);
    }
    volume += p[0].Dot(p[1].Crossed(p[2]));
  }
  std::sort(ways.begin(), ways.end());
  std::sort(back.begin(), back.end());
  return volume > 0.0 && ways == back;
}

Facets facetsOf(const TopoDS_Shape& body, double chord_mm, double free_chord_mm) {
  Facets out;
  for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next()) {
    out.faces.push_back(TopoDS::Face(face.Current()));
    out.surfaces.push_back(surfaceOf(out.faces.back()));
  }
  const bool free = std::any_of(out.surfaces.begin(), out.surfaces.end(),
                                [](const FaceSurface& s) { return s.kind == kOther; });
  IMeshTools_Parameters mesh;
  mesh.MeshAlgo =
      IMeshTools_MeshAlgoType_Delabella;  // the other one takes square time on faces with many holes
  mesh.Deflection = free ? kMargin * free_chord_mm : chord_mm;
  mesh.Angle = kMostTurn;
  mesh.InParallel = true;
  BRepMesh_IncrementalMesh(body, mesh);
  for (std::size_t k = 0; k < out.faces.size(); ++k) addFace(k, out);
  return out;
}

}  // namespace proveout::step_reader

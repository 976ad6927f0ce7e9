#include "removal/surface/mesh/mesh_writer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"

namespace proveout {

namespace {

/// Around triangles that lean more than this (60 degrees) the surface may run through itself.
constexpr double kPoorAgreement = 0.5;

/// Resizes a vector whose contents will all be written, with room for `spare` more. The system clears fresh
/// pages where they are first touched: so that happens in all threads, and not in the one that would fill
/// the vector with zeros.
template <typename T>
void resizeTouched(std::vector<T>& vector, std::size_t size, std::size_t spare) {
  constexpr std::size_t kPage = 4096, kStretch = std::size_t{1} << 21, kGrowth = 16;
  if (size + spare > vector.capacity()) {
    vector.clear();
    vector.reserve(size + spare + size / kGrowth);  // later rounds take a little more
    auto* const bytes = reinterpret_cast<volatile char*>(vector.data());
    const std::size_t count = (size + spare) * sizeof(T);
    parallelFor(std::size_t{0}, count / kStretch + 1, [&](std::size_t i) {
      for (std::size_t k = i * kStretch; k < std::min(count, (i + 1) * kStretch); k += kPage) bytes[k] = 0;
    });
  }
  vector.resize(size);
}

}  // namespace

MeshWriter::MeshWriter(const SurfaceGrid& grid, const VertexMerger& merger) : grid_(grid), merger_(merger) {}

std::uint32_t MeshWriter::keptCells(const SurfaceLeaf& leaf) const {
  std::uint32_t kept = 0;
  for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k) kept += merger_.standIn(k) == k;
  return kept;
}

/// Assigns places to the vertices that stay and to the triangles: cells leaf by leaf, then further sheets.
void MeshWriter::layOut(const std::vector<LeafQuads>& quads, const std::vector<std::uint8_t>& changed) {
  const std::size_t leaves = quads.size();
  now_.cells = static_cast<std::uint32_t>(grid_.cellCount());
  now_.sheets = static_cast<std::uint32_t>(grid_.vertexCount() - grid_.cellCount());
  now_.parts.resize(leaves);
  now_.poor.resize(leaves);
  now_.kept = 0;
  if (merger_.active()) {
    if (!now_.number) now_.number = std::make_unique_for_overwrite<std::uint32_t[]>(now_.cells);
    parallelFor(std::size_t{0}, leaves, [&](std::size_t i) {
      now_.parts[i].vertices = changed[i] != 0 ? keptCells(grid_.leaves()[i]) : before_.parts[i].vertices;
    });
  }
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < leaves; ++i) {
    LeafPart& part = now_.parts[i];
    part.first_vertex = now_.kept;
    now_.kept += part.vertices;
    part.first_triangle = triangles;
    part.triangles = quads[i].triangles;
    triangles += part.triangles;
  }
  if (!merger_.active()) now_.kept = now_.cells;
}

void MeshWriter::makeRoom(const std::vector<LeafQuads>& quads) {
  const std::size_t triangles = now_.firstFanTriangle();
  std::size_t fan_vertices = 0, fan_triangles = 0;
  for (const LeafQuads& leaf : quads) {
    for (const SplitQuad& fan : leaf.fans) {
      fan_vertices += 1 + fan.faces.size();
      fan_triangles += 4 + fan.faces.size();
    }
  }
  if (merger_.active()) resizeTouched(now_.cell_at, now_.kept, 0);
  resizeTouched(now_.mesh.positions, now_.firstOfFans(), fan_vertices);
  resizeTouched(now_.mesh.triangles, triangles, fan_triangles);
  resizeTouched(now_.mesh.motion, triangles, fan_triangles);
}

void MeshWriter::writeVertices(const SurfaceLeaf& leaf, std::size_t number, bool changed) {
  const Stock::Impl& impl = grid_.impl();
  const Vec3 origin = impl.position(leaf.stock->origin);
  const auto write = [&](std::uint32_t at, const Eigen::Vector3f& p) {
    now_.mesh.positions[at] = toFloat(origin + impl.h * p.cast<double>());
  };
  for (std::uint32_t k = 0; k < leaf.extra.size(); ++k)
    write(now_.numberOf(leaf.extra_base + k), leaf.extra[k].p);
  if (!merger_.active()) {
    for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k) write(k, grid_.vertex(k));
    return;
  }
  if (!changed) return copyVertices(number);
  const LeafPart& part = now_.parts[number];
  std::uint32_t next = part.first_vertex;
  for (std::uint32_t k = leaf.base; k < leaf.base + leaf.cells; ++k) {
    if (merger_.standIn(k) != k) continue;
    now_.number[k] = next;
    now_.cell_at[next] = k;
    write(next++, grid_.vertex(k));
  }
  PROVEOUT_ASSERT(next == part.first_vertex + part.vertices);
}

/// Copies the vertices of the cells of a leaf that did not change from the mesh before.
void MeshWriter::copyVertices(std::size_t number) {
  const LeafPart &part = now_.parts[number], &old = before_.parts[number];
  for (std::uint32_t i = 0; i < part.vertices; ++i) {
    const std::uint32_t cell = before_.cell_at[old.first_vertex + i], next = part.first_vertex + i;
    now_.number[cell] = next;
    now_.cell_at[next] = cell;
    now_.mesh.positions[next] = before_.mesh.positions[old.first_vertex + i];
  }
}

void MeshWriter::writeLeaf(const SurfaceLeaf& leaf, const LeafQuads& quads, std::size_t number) {
  std::vector<std::uint32_t>& poor = now_.poor[number];
  poor.clear();
  if (quads.triangles == 0) return;
  const std::size_t first = now_.parts[number].first_triangle;
  std::size_t next = first;
  QuadReader reader(grid_);
  reader.load(leaf);
  const std::uint8_t* of_quad = quads.states.data();
  forEachCrossing(leaf, [&](int axis, int x, int y, int z, const Crossing& c) {
    const std::uint8_t state = *of_quad++;
    if (state & QuadState::kFan) return;
    Quad quad;
    reader.readCorners(axis, x, y, z, quad);
    if (state & QuadState::kMerged) {
      if (polygonOf(merger_, quad.v).count == 0) return;
      reader.read(axis, x, y, z, c, quad);
      next = writeMerged(leaf, quad, c, first, next, poor);
    } else {
      std::array<std::uint32_t, 4> v;
      for (int i = 0; i < 4; ++i) v[i] = now_.numberOf(quad.v[i]);
      next = writeQuad(v, state & QuadState::kAt02, state & QuadState::kPoor, c, first, next, poor);
    }
  });
  PROVEOUT_ASSERT(next == now_.parts[number].lastTriangle());
}

/// Writes the triangles of a quad from number `next` on; returns the number after them. `first`: of the leaf.
std::size_t MeshWriter::writeQuad(const std::array<std::uint32_t, 4>& v, bool at02, bool leans,
                                  const Crossing& c, std::size_t first, std::size_t next,
                                  std::vector<std::uint32_t>& poor) {
  now_.mesh.triangles[next] = {v[0], v[1], v[at02 ? 2 : 3]};
  now_.mesh.triangles[next + 1] = {v[at02 ? 0 : 1], v[2], v[3]};
  now_.mesh.motion[next] = now_.mesh.motion[next + 1] = knownMotion(c.motion);
  for (std::size_t t = next; leans && t < next + 2; ++t)
    poor.push_back(static_cast<std::uint32_t>(t - first));
  return next + 2;
}

/// Writes a quad with merged corners, cut where those are now; arguments as above.
std::size_t MeshWriter::writeMerged(const SurfaceLeaf& leaf, Quad& quad, const Crossing& c, std::size_t first,
                                    std::size_t next, std::vector<std::uint32_t>& poor) {
  const Polygon poly = polygonOf(merger_, quad.v);
  std::array<std::uint32_t, 4> v;
  for (int i = 0; i < poly.count; ++i) {
    v[i] = now_.numberOf(poly.v[i]);
    quad.p[i] = now_.mesh.positions[v[i]].cast<double>();
  }
  if (poly.count == 4) {
    const Vec3 middle = grid_.impl().position(leaf.stock->origin) + grid_.impl().h * quad.middle;
    const QuadCut cut = cutQuad(quad.p, middle, quad.normal, 0u);
    return writeQuad(v, cut.at02, cut.poor, c, first, next, poor);
  }
  now_.mesh.triangles[next] = {v[0], v[1], v[2]};
  now_.mesh.motion[next] = knownMotion(c.motion);
  const Vec3 area = (quad.p[1] - quad.p[0]).cross(quad.p[2] - quad.p[0]);
  if (quad.normal.dot(area) < kPoorAgreement * area.norm())
    poor.push_back(static_cast<std::uint32_t>(next - first));
  return next + 1;
}

/// Copies the triangles of a leaf that did not change, with the vertices' new numbers.
void MeshWriter::copyLeaf(std::size_t number) {
  const LeafPart &part = now_.parts[number], &old = before_.parts[number];
  PROVEOUT_ASSERT(part.triangles == old.triangles);
  for (std::size_t k = 0; k < part.triangles; ++k) {
    auto t = before_.mesh.triangles[old.first_triangle + k];
    for (std::uint32_t& v : t)
      v = v < before_.kept ? now_.numberOf(before_.cellAt(v)) : v - before_.kept + now_.kept;
    now_.mesh.triangles[part.first_triangle + k] = t;
    now_.mesh.motion[part.first_triangle + k] = before_.mesh.motion[old.first_triangle + k];
  }
}

/// Writes the fans around crossings. Fans at a face where sheets touch share its vertex.
void MeshWriter::writeFans(const std::vector<LeafQuads>& quads) {
  TriMesh& mesh = now_.mesh;
  std::map<std::array<int, 7>, std::uint32_t> at_face;
  now_.fan_at.clear();
  const SplitQuad* fan = nullptr;
  const auto newVertex = [&](const Eigen::Vector3f& p) {
    mesh.positions.push_back(p);
    now_.fan_at.push_back(fan);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (std::size_t i = 0; i < quads.size(); ++i) {
    now_.parts[i].first_fan = mesh.triangles.size();
    for (const SplitQuad& split : quads[i].fans) {
      fan = &split;
      std::vector<std::uint32_t> ring;
      std::size_t next = 0;
      for (int corner = 0; corner < 4; ++corner) {
        ring.push_back(now_.numberOf(merger_.standIn(split.v[corner])));
        for (; next < split.faces.size() && split.faces[next].after == corner; ++next) {
          const auto [it, fresh] = at_face.emplace(split.faces[next].key, 0);
          if (fresh) it->second = newVertex(split.faces[next].p);
          ring.push_back(it->second);
        }
      }
      PROVEOUT_ASSERT(next == split.faces.size());  // they are in the order of the corners
      const std::uint32_t middle = newVertex(split.middle);
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::uint32_t a = ring[k], b = ring[(k + 1) % ring.size()];
        if (a == b) continue;
        mesh.triangles.push_back({middle, a, b});
        mesh.motion.push_back(split.motion);
      }
    }
  }
}

LeafMesh* MeshWriter::write(const std::vector<LeafQuads>& quads, const std::vector<std::uint8_t>& changed,
                            Progress& progress) {
  std::swap(now_, before_);
  now_.number = std::move(before_.number);
  std::swap(now_.poor, before_.poor);
  layOut(quads, changed);
  makeRoom(quads);
  const auto eachLeaf = [&](auto&& body) {
    parallelFor(std::size_t{0}, quads.size(), [&](std::size_t i) {
      if (!progress.cancelled()) body(grid_.leaves()[i], i);
    });
  };
  eachLeaf([&](const SurfaceLeaf& leaf, std::size_t i) { writeVertices(leaf, i, changed[i] != 0); });
  eachLeaf([&](const SurfaceLeaf& leaf, std::size_t i) {
    if (changed[i] != 0) {
      writeLeaf(leaf, quads[i], i);
    } else {
      copyLeaf(i);
    }
  });
  if (progress.cancelled()) return nullptr;
  writeFans(quads);
  PROVEOUT_ASSERT_DEAR(isDense(now_));
  return &now_;
}

}  // namespace proveout

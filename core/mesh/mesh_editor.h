// Changes of a closed 2-manifold triangle mesh that keep it one, each of which can be taken back.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "core/mesh/vertex_fans.h"

namespace proveout {

/// An edge and its two triangles.
struct MeshWing {
  std::uint32_t a = 0, b = 0, c = 0, d = 0;  ///< vertices; the edge is ab, the triangles abc and bad
  std::uint32_t abc = 0, bad = 0;
};

/// Keeps the fans around vertices as the triangles are. Triangles that go stay in the list, without corners,
/// until takeOut.
class MeshEditor {
 public:
  /// Whether a triangle that changes stays where it is in the fans of corners that it keeps, or goes to their
  /// end: what is summed up over a fan depends on the order.
  enum class FanOrder { kKept, kRenewed };
  /// A corner of a triangle that is gone.
  static constexpr std::uint32_t kGone = 0xFFFFFFFFu;
  /// How far the changes are.
  using Mark = std::size_t;

  /// `mesh` must outlive this, and change by it alone; motions: none, or one a triangle.
  MeshEditor(TriMesh& mesh, FanOrder order) : mesh_(mesh), order_(order), fans_(mesh) {}
  /// Knows these triangles only: what is asked or changed must lie at vertices that have no others.
  MeshEditor(TriMesh& mesh, FanOrder order, std::span<const std::uint32_t> triangles)
      : mesh_(mesh), order_(order), fans_(mesh, triangles) {}

  const TriMesh& mesh() const { return mesh_; }
  /// The triangles around a vertex. Valid until one of them changes.
  std::span<const std::uint32_t> fan(std::uint32_t v) const { return fans_[v]; }
  bool gone(std::uint32_t t) const { return mesh_.triangles[t][0] == kGone; }
  /// The corner `steps` (0 to 2) after `v` in a triangle that has it.
  std::uint32_t following(std::uint32_t t, std::uint32_t v, std::size_t steps) const;
  /// None where there is no such edge, or its triangles are the same from both sides.
  std::optional<MeshWing> wing(std::uint32_t a, std::uint32_t b) const;

  /// Whether the mesh stays a closed 2-manifold without vertices of fewer than three triangles.
  bool canFlip(const MeshWing& w) const;
  /// By the link condition: no vertex but c and d is a neighbour of both ends (T. Dey, H. Edelsbrunner, S.
  /// Guha, D. Nekhayev, "Topology preserving edge contraction", 1999).
  bool canCollapse(const MeshWing& w) const;

  /// Joins c and d in place of a and b: abc becomes adc, bad becomes dbc. Requires canFlip.
  void flip(const MeshWing& w);
  /// Puts a vertex onto the edge: abc becomes axc, bad becomes bxd; xbc and xad are new, in this order, with
  /// the motions of abc and bad. Returns x.
  std::uint32_t split(const MeshWing& w, const Eigen::Vector3f& x);
  /// Joins a with b, which stays where it is: a has no triangles any more, abc and bad are gone. Requires
  /// canCollapse.
  void collapse(const MeshWing& w);
  void move(std::uint32_t v, const Eigen::Vector3f& p);
  /// Makes another corner of a triangle the first: each goes `steps` (0 to 2) places ahead.
  void rotate(std::uint32_t t, int steps);
  /// Requires a mesh with motions.
  void setMotion(std::uint32_t t, std::uint32_t motion);

  Mark mark() const { return done_.size(); }
  /// Takes back what was done since then: mesh and fans are what they were, bit for bit.
  void takeBack(Mark mark);
  /// What was done is not to be taken back any more; earlier marks are void.
  void keep() { done_.clear(); }
  /// Flags of the vertices of what was done: those that moved or are new, and the corners of triangles that
  /// changed, as they are now.
  std::vector<std::uint8_t> touched() const;

  /// Whether fans and triangles say the same. Looks at all; for editors of whole meshes.
  bool isConsistent() const;

 private:
  using Triangle = std::array<std::uint32_t, 3>;
  struct Step {
    enum Kind : std::uint8_t { kMoved, kNewVertex, kTriangle, kNewTriangle, kLeftFan, kJoinedFan, kReplaced };
    Kind kind;
    std::uint32_t index;      ///< of the vertex or triangle
    std::uint32_t other = 0;  ///< the triangle that was in the fan; the motion
    std::uint32_t place = 0;  ///< in the fan
    Triangle corners{};
    Eigen::Vector3f p = Eigen::Vector3f::Zero();
  };
  struct Shape {
    std::uint32_t triangle;
    Triangle corners;
  };

  void reshape(std::span<const Shape> shapes);
  std::uint32_t addTriangle(const Triangle& corners, std::uint32_t motion);
  void save(std::uint32_t t);
  void leaveFan(std::uint32_t v, std::uint32_t t);
  void joinFan(std::uint32_t v, std::uint32_t t);
  void replaceInFan(std::uint32_t v, std::uint32_t t, std::uint32_t by);
  void takeBack(const Step& step);

  TriMesh& mesh_;
  FanOrder order_;
  VertexFans fans_;
  std::vector<Step> done_;
};

/// What is not in a mesh any more.
struct LostParts {
  std::vector<std::uint32_t> triangles, vertices;  ///< numbers; each once, in any order
};
/// Takes few triangles and vertices out of many, and numbers the vertices anew. No triangle that stays may
/// have a vertex that goes.
void takeOut(TriMesh& mesh, LostParts lost);

}  // namespace proveout

// Fixtures of clampings that a wire cuts in: closed surfaces, without a grid.
#pragma once

#include <string>
#include <vector>

#include "app/session/run/process.h"
#include "core/mesh/surface_mesh.h"

namespace proveout {

class WireFixtures final : public Fixtures {
 public:
  /// Errors: a mesh that cannot be read or is not closed (names the fixture).
  static Result<WireFixtures> create(const std::vector<FixtureSpec>& specs);

  /// Where they reach between the heights of the blank: what they touch there is held.
  void hold(const Box3& blank, PieceOptions& options) const override;
  std::vector<std::string> repairs() const override { return repairs_; }
  /// Whether the wire cuts or not; it does not cut a fixture.
  Status addContacts(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings,
                     Progress& progress) override;

 private:
  struct Solid {
    std::string name;
    SurfaceMesh surface;
  };
  std::vector<Solid> solids_;
  std::vector<std::string> repairs_;
};

}  // namespace proveout

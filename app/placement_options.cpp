#include "app/placement_options.h"

#include <charconv>
#include <cmath>

#include "io/step/step_file.h"

namespace proveout {

Result<Vec3> parseTriple(const std::string& option, const std::string& text, double most,
                         const std::string& what) {
  Vec3 out;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int k = 0; k < 3; ++k) {
    const auto [next, error] = std::from_chars(at, end, out[k]);
    const bool separated = k == 2 ? next == end : next != end && *next == ',';
    if (error != std::errc() || !separated || !std::isfinite(out[k]) || std::abs(out[k]) > most)
      return inputError(option + ": '" + text + "' is not " + what);
    at = next + 1;
  }
  return out;
}

Status applyNominal(const NominalOptions& options, NominalSpec& nominal) {
  MeshPlacement& placement = nominal.placement;
  if (options.body) {
    if (!isStepFile(nominal.mesh.path))
      return inputError("--nominal-body names a body of a STEP file; " + nominal.mesh.path + " is a mesh");
    nominal.mesh.body = *options.body;
  }
  if (options.at) {
    const Result<Vec3> at = parseTriple("--nominal-at", *options.at, 1e6, "a point: X,Y,Z in mm");
    if (!at) return at.error();
    placement.move = *at;
  }
  if (options.rotate) {
    const Result<Vec3> turn = parseTriple("--nominal-rotate", *options.rotate, 360.0,
                                          "three angles from -360 to 360 degrees: A,B,C");
    if (!turn) return turn.error();
    placement.rotate_deg = *turn;
  }
  return Done{};
}

}  // namespace proveout

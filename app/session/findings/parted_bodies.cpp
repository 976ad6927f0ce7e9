#include "app/session/findings/parted_bodies.h"

#include <fmt/format.h>

#include "app/session/findings/blame.h"

namespace proveout {

void addPartedBodies(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  const Toolpath& path = setup.interpreted.path;
  for (const auto& [k, by] : setup.form->parted()) {
    Finding finding(FindingKind::kPartOff);
    finding.volume_mm3 = setup.bodies[k].volume_mm3;  // with its threads
    const Box3& bounds = setup.bodies[k].bounds;
    finding.where = Vec3(0.0, 0.0, 0.5 * (bounds.min.z() + bounds.max.z()));
    finding.message = fmt::format(
        "{} of {:.4g} mm3, Z{:.3f} to Z{:.3f}, is cut off here; nothing cuts it any more",
        k == 0 ? "the part" : "a piece", setup.bodies[k].volume_mm3, bounds.min.z(), bounds.max.z());
    blame(finding, by, path, texts);
    findings.push_back(std::move(finding));
  }
}

}  // namespace proveout

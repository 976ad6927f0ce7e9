#include "app/session/programs/rotary_motions.h"

#include <fmt/format.h>

#include <string>

namespace proveout {

namespace {

/// An axis that moves nothing in the job and is not at 0.
std::string unplacedAxis(const AxisSweep& axis) {
  for (int k = 0; k < axis.rotary_count; ++k) {
    const RotaryPosition& rotary = axis.rotary[static_cast<std::size_t>(k)];
    if (!rotary.in_path && (rotary.from != 0.0 || rotary.to != 0.0)) return rotary.name.data();
  }
  return {};
}

}  // namespace

bool checkRotaryMotions(Toolpath& path, const RecordingSource& source) {
  for (const Motion& motion : path.motions) {
    if (motion.axis < 0) continue;
    const std::string name = unplacedAxis(path.axes[static_cast<std::size_t>(motion.axis)]);
    if (name.empty()) continue;
    const BlockRef block = blockRef(path, motion.source, source);
    Diagnostic diagnostic;
    diagnostic.code = "rotary-motion";
    diagnostic.message = fmt::format(
        "this motion uses rotary axis {}, and nothing says what it turns: describe it in the machine file or "
        "by carries = \"part\" in [[machine.axis]]",
        name);
    diagnostic.where = {block.file, static_cast<int>(block.line), 0, 0};
    diagnostic.source_line = block.text;
    path.diagnostics.add(std::move(diagnostic));
    return false;
  }
  return true;
}

}  // namespace proveout

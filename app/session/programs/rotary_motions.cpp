#include "app/session/programs/rotary_motions.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <vector>

#include "app/session/nominal/nominal_mesh.h"
#include "core/geometry/place_text.h"
#include "core/tool/tool_type.h"
#include "removal/contact/posed_clearance.h"
#include "removal/grid/shape_field.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {

namespace {

void addError(Toolpath& path, const RecordingSource& source, const Motion& motion, const char* code,
              std::string message) {
  const BlockRef block = blockRef(path, motion.source, source);
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.message = std::move(message);
  diagnostic.where = {block.file, static_cast<int>(block.line), 0, 0};
  diagnostic.source_line = block.text;
  path.diagnostics.add(std::move(diagnostic));
}

/// The bodies around a tool, made when they are first asked for.
class Bodies {
 public:
  explicit Bodies(const Surroundings& around) : around_(around) {}

  std::span<const BlankField* const> all() {
    if (!made_) make();
    return seen_;
  }
  const ToolSolid* tool(int number) {
    if (const auto found = tools_.find(number); found != tools_.end()) return found->second.get();
    std::unique_ptr<ToolSolid> solid;
    for (const Tool& tool : around_.job.tools) {
      if (tool.number == number && rowOf(tool.type).rotates)
        solid = std::make_unique<ToolSolid>(makeToolSolid(tool));
    }
    return tools_.emplace(number, std::move(solid)).first->second.get();
  }

 private:
  void make() {
    made_ = true;
    if (around_.blank != nullptr) {
      const bool first = around_.setup == 0 && !std::holds_alternative<SavedStock>(around_.blank->shape);
      const Box3 box = movedBounds(around_.job, around_.blank->bounds, around_.setup);
      take(first ? around_.blank->shape : StockShape(BoxShape{box.min, box.max}));
    }
    for (const FixtureSpec& fixture : around_.job.fixtures) {
      if (const Result<LoadedSolid> solid = loadSolid(fixture.shape)) take(solid->shape);
    }
    for (const auto& field : fields_) seen_.push_back(field.get());
  }
  /// What cannot be read is told where the run reads it.
  void take(const StockShape& shape) {
    if (Result<std::unique_ptr<BlankField>> field = shapeField(shape); field && *field != nullptr)
      fields_.push_back(std::move(*field));
  }

  const Surroundings& around_;
  bool made_ = false;
  std::vector<std::unique_ptr<BlankField>> fields_;
  std::vector<const BlankField*> seen_;
  std::map<int, std::unique_ptr<ToolSolid>> tools_;
};

/// An axis that moves nothing in the job and is not at 0.
std::string unplacedAxis(const AxisSweep& axis) {
  for (int k = 0; k < axis.rotary_count; ++k) {
    const RotaryPosition& rotary = axis.rotary[static_cast<std::size_t>(k)];
    if (!rotary.in_path && (rotary.from != 0.0 || rotary.to != 0.0)) return rotary.name.data();
  }
  return {};
}

}  // namespace

bool checkRotaryMotions(Toolpath& path, const RecordingSource& source, const Surroundings& around) {
  Bodies bodies(around);
  for (const Motion& motion : path.motions) {
    if (motion.axis < 0) continue;
    const AxisSweep& axis = path.axes[static_cast<std::size_t>(motion.axis)];
    if (const std::string name = unplacedAxis(axis); !name.empty()) {
      addError(
          path, source, motion, "rotary-motion",
          fmt::format(
              "this motion uses rotary axis {}, and nothing says what it turns: describe it in the machine "
              "file or by carries = \"part\" in [[machine.axis]]",
              name));
      return false;
    }
    if (!wayOf(path, motion).turns()) continue;
    const ToolSolid* tool = bodies.tool(motion.tool);
    if (tool == nullptr) continue;  // told where tools are assigned
    const auto unclear = firstUnclear(path, motion, axis, *tool, bodies.all());
    if (!unclear) continue;
    addError(
        path, source, motion, "posed-motion",
        fmt::format(
            "the tool's axis turns in this motion, and the tool may touch blank or fixture near {}: this "
            "version cuts while the axis stands still, and turns it in the air only; retract before the "
            "axis turns",
            placeText(unclear->point)));
    return false;
  }
  return true;
}

}  // namespace proveout

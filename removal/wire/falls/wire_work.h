// What a path does with its wire, at the heights of a workpiece.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/wire/lean/lean_stretch.h"
#include "removal/wire/section/wire_stretch.h"

namespace proveout {

/// At one height: stretches that cut, in program order, and rapid ones between them.
struct WireWork {
  std::vector<WireStretch> cuts;
  struct Rapid {
    WireStretch stretch;  ///< of the wire itself: its sparks do not count
    std::uint32_t after;  ///< stretches of `cuts` that come before it
  };
  std::vector<Rapid> rapids;
};

/// Of a wire that leans somewhere.
struct LeanWork {
  std::vector<LeanStretch> cuts;
  struct Rapid {
    LeanStretch stretch;
    std::uint32_t after;
  };
  std::vector<Rapid> rapids;
  /// At a height, as circles for the ellipses that they are.
  WireWork atHeight(const HeightSpan& span, double z) const;
};

/// Whether the wire stands upright on all motions on which it is threaded.
bool standsUpright(const Toolpath& path);

/// Errors, of both: a tool that is no wire or is missing.
/// Requires a wire that stands upright.
Result<WireWork> wireWork(const Toolpath& path, const std::vector<Tool>& tools);
/// `twist_mm`: see addLeanStretches().
Result<LeanWork> leanWork(const Toolpath& path, const std::vector<Tool>& tools, const HeightSpan& span,
                          double twist_mm);

}  // namespace proveout

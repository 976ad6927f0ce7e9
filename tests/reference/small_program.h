// Random small programs of lines and arcs in a block. All mm.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock_shape.h"

namespace proveout::reference {

struct SmallProgram {
  BoxShape block;
  std::vector<Tool> tools;
  Toolpath path;
};

/// A few motions of one or two cutters that follow each other; tools, lines and arcs of all kinds that
/// sweep() knows. The same on every machine.
SmallProgram smallProgram(std::uint64_t seed);

/// In words that `proveout` reads, to run it by hand.
std::string describe(const SmallProgram& program);

}  // namespace proveout::reference

// Motions for tests that make tool paths by hand.
#pragma once

#include "core/path/toolpath.h"

namespace proveout::test {

/// A straight feed of tool 1 with the spindle on, of line 1.
inline Motion feedMotion(const Vec3& from, const Vec3& to) {
  Motion m;
  m.from = from;
  m.to = to;
  m.kind = MotionKind::kFeed;
  m.tool = 1;
  m.spindle = 1000;
  m.source.line = 1;
  return m;
}

}  // namespace proveout::test

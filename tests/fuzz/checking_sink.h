// A sink for any program: nothing that it gets may be infinite, leap or be without text.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/nc/interpreter.h"

namespace proveout {

class CheckingSink : public MotionSink {
 public:
  void file(std::uint32_t, const std::string&) override {}
  void motion(const Motion& m, const ArcGeometry* arc, const AxisSweep*) override {
    const bool finite = m.from.allFinite() && m.to.allFinite() && std::isfinite(m.feed) &&
                        std::isfinite(m.time_s) &&
                        (arc == nullptr || (arc->center.allFinite() && std::isfinite(arc->sweep_rad)));
    if (!finite || m.time_s < 0.0 || m.feed < 0.0) std::abort();
    if (seen_ && (m.from - last_).norm() > 1e-6 * (1.0 + last_.norm())) std::abort();
    seen_ = true;
    last_ = m.to;
  }
  void event(const PathEvent&) override {}
  void diagnostic(const Diagnostic& d) override {
    if (formatDiagnostic(d).empty()) std::abort();
  }

 private:
  bool seen_ = false;
  Vec3 last_;
};

}  // namespace proveout

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
    if (m.source.origins < 0 || static_cast<std::uint32_t>(m.source.origins) >= sets_) std::abort();
    if (!finite || m.time_s < 0.0 || m.feed < 0.0) std::abort();
    if (seen_ && (m.from - last_).norm() > 1e-6 * (1.0 + last_.norm())) std::abort();
    seen_ = true;
    last_ = m.to;
  }
  void event(const PathEvent&) override {}
  void diagnostic(const Diagnostic& d) override {
    if (formatDiagnostic(d).empty()) std::abort();
  }
  // Origins refer to what has come before.
  void originWord(const WordOrigin& word) override {
    for (const std::uint32_t from : word.from) {
      if (from == 0 || from > words_) std::abort();
    }
    if (word.line == 0) std::abort();
    ++words_;
  }
  void originData(const DataInForce&) override { ++data_; }
  void originModal(const ModalOrigins& modal) override {
    for (const OriginCode code : modal.code) check(code);
    if (modal.data >= data_) std::abort();
    ++modal_;
  }
  void originSet(const OriginSet& set) override {
    for (const OriginCode code : set.axis) check(code);
    if (set.modal >= modal_) std::abort();
    ++sets_;
  }

 private:
  void check(OriginCode code) const {
    if (code.isWord() && code.number() > words_) std::abort();
  }

  std::uint32_t words_ = 0, data_ = 0, modal_ = 0, sets_ = 0;
  bool seen_ = false;
  Vec3 last_;
};

}  // namespace proveout

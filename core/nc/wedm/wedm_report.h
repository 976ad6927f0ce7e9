// Diagnostics of the wire EDM control.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/control/run_summary.h"
#include "core/nc/flow/flow_frame.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/wedm/wedm_program.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

class WedmReport {
 public:
  /// All must outlive the report.
  WedmReport(MotionSink& sink, InterpretSummary& summary, const WedmProgram& program,
             const std::vector<FlowFrame>& levels, OriginRecorder& recorder)
      : sink_(sink), summary_(summary), program_(program), levels_(levels), recorder_(recorder) {}

  /// Always false. Without columns all of the block.
  bool fail(std::string code, std::string message, Columns at = {});
  /// At a block that has gone by.
  bool failAt(const SourceRef& at, Columns columns, std::string code, std::string message);
  void warnAt(const SourceRef& at, Columns columns, std::string code, std::string message) {
    tell(Severity::kWarning, at, columns, std::move(code), std::move(message));
  }
  void warn(std::string code, std::string message, Columns at = {});
  /// Once a run for each code.
  void warnOnce(std::string code, std::string message, Columns at = {});
  /// The block in hand with the words in force.
  SourceRef here();
  /// Columns of the block in hand.
  Columns blockColumns() const;

 private:
  void tell(Severity severity, const SourceRef& at, Columns columns, std::string code, std::string message);

  MotionSink& sink_;
  InterpretSummary& summary_;
  const WedmProgram& program_;
  const std::vector<FlowFrame>& levels_;
  OriginRecorder& recorder_;
  std::set<std::string, std::less<>> told_;
};

}  // namespace proveout::nc

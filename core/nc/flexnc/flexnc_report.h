// Diagnostics of the FlexNC control.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/nc/flexnc/flexnc_program.h"
#include "core/nc/flow/flow_frame.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/stages/rolling_comp_stage.h"

namespace proveout::nc {

/// The main program, and calls of subprograms in its text.
using FlexLevels = std::vector<FlowFrame>;

/// Where a cycle is that the block in hand runs.
struct FlexCyclePlace {
  std::uint32_t file = 0;    ///< of the path; 0: no cycle runs
  std::uint32_t motion = 0;  ///< from 1
};

class FlexReport final : public RollingCompReport {
 public:
  /// All must outlive the report.
  FlexReport(PathEmitter& emitter, const FlexProgram& program, const FlexLevels& levels,
             OriginRecorder& recorder)
      : emitter_(emitter), program_(program), levels_(levels), recorder_(recorder) {}

  /// Always false. Without columns the whole line.
  bool fail(std::string code, std::string message, Columns at = {});
  void warn(std::string code, std::string message, Columns at = {}) {
    tell(Severity::kWarning, here(), at, std::move(code), std::move(message));
  }
  /// Once a run for each key.
  void warnOnce(const std::string& key, std::string code, std::string message, Columns at = {});
  void note(const std::string& key, std::string code, std::string message, Columns at = {});
  /// The block in hand, or the motion of its cycle, with the words in force.
  SourceRef here();

  /// What `here` tells until the cycle ends (a place with file 0).
  void inCycle(const FlexCyclePlace& place) { cycle_ = place; }

  void compError(CompFault fault, const std::string& message, const SourceRef& at) override;
  void compWarning(CompFault fault, const std::string& message, const SourceRef& at) override;

 private:
  /// The block that the user wrote, for places in a cycle too.
  SourceRef written(const SourceRef& at) const;
  void tell(Severity severity, const SourceRef& at, Columns columns, std::string code, std::string message);

  PathEmitter& emitter_;
  const FlexProgram& program_;
  const FlexLevels& levels_;
  OriginRecorder& recorder_;
  FlexCyclePlace cycle_;
  std::set<std::string, std::less<>> told_;
};

}  // namespace proveout::nc

// Diagnostics of the WL4 control.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "core/nc/origins/origin_recorder.h"
#include "core/nc/stages/contour_stage.h"
#include "core/nc/stages/path_emitter.h"
#include "core/nc/stages/rolling_comp_stage.h"
#include "core/nc/wl4/wl4_block.h"
#include "core/nc/wl4/wl4_levels.h"
#include "core/nc/wl4/wl4_programs.h"

namespace proveout::nc {

/// Reports at the block in hand; the stages of the pipe at blocks that have gone by.
class Wl4Report final : public ContourReport, public RollingCompReport {
 public:
  /// All must outlive the report.
  Wl4Report(PathEmitter& emitter, const Wl4Programs& programs, const Wl4Levels& levels, const Wl4Block& block,
            OriginRecorder& recorder)
      : emitter_(emitter), programs_(programs), levels_(levels), block_(block), recorder_(recorder) {}

  /// Always false.
  bool fail(std::string code, std::string message, Columns at = {});
  void warn(std::string code, std::string message, Columns at = {}, Severity severity = Severity::kWarning);
  /// Once a run for each key.
  void warnOnce(const std::string& key, std::string code, std::string message, Columns at = {});
  /// The block in hand with the words in force.
  SourceRef here();

  bool contourError(SharedAlarm alarm, std::string_view subject, std::string_view detail,
                    const PathItem& at) override;
  void compError(CompFault fault, const std::string& message, const SourceRef& at) override;

 private:
  Diagnostic diagnosticAt(Severity severity, std::string code, std::string message, const SourceRef& at,
                          Columns columns) const;

  PathEmitter& emitter_;
  const Wl4Programs& programs_;
  const Wl4Levels& levels_;
  const Wl4Block& block_;
  OriginRecorder& recorder_;
  std::set<std::string, std::less<>> told_;
};

}  // namespace proveout::nc

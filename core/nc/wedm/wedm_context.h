// What a run of the wire EDM control is made of. Free functions plan and perform over it.
#pragma once

#include <fmt/core.h>

#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/nc/flow/run_watch.h"
#include "core/nc/origins/origin_recorder.h"
#include "core/nc/wedm/wedm_chain.h"
#include "core/nc/wedm/wedm_codes.h"
#include "core/nc/wedm/wedm_parameters.h"
#include "core/nc/wedm/wedm_program.h"
#include "core/nc/wedm/wedm_report.h"
#include "core/nc/wedm/wedm_state.h"

namespace proveout::nc {

/// The variables H, mm.
class WedmVariables {
 public:
  void start(const std::array<double, kWedmOffsets>& values) { values_ = values; }
  double value(int h) const { return values_[static_cast<std::size_t>(h)]; }
  bool assigned(int h) const { return assigned_[static_cast<std::size_t>(h)] || value(h) != 0.0; }
  void assign(int h, double value) {
    const auto k = static_cast<std::size_t>(h);
    undo_.push_back({k, values_[k], assigned_[k]});
    values_[k] = value;
    assigned_[k] = true;
  }
  /// From here on takeBack() restores.
  void mark() { undo_.clear(); }
  void takeBack() {
    for (auto it = undo_.rbegin(); it != undo_.rend(); ++it) {
      values_[it->h] = it->value;
      assigned_[it->h] = it->assigned;
    }
    undo_.clear();
  }

 private:
  struct Old {
    std::size_t h;
    double value;
    bool assigned;
  };
  std::array<double, kWedmOffsets> values_{};
  std::bitset<kWedmOffsets> assigned_;
  std::vector<Old> undo_;
};

struct WedmContext {
  /// What is referred to must outlive the context; `progress` may be null.
  WedmContext(const ProgramSource& source_in, const ControlSettings& settings_in, MotionSink& sink_in,
              Progress* progress)
      : source(source_in),
        settings(settings_in),
        sink(sink_in),
        recorder(sink_in),
        report(sink_in, summary, program, levels, recorder),
        output(sink_in, summary, settings, parameters),
        chain(output, report, parameters),
        watch(
            summary, progress, settings_in.block_limit, [this] { return loopState(); },
            [this](const char* what, const std::string& message) {
              report.fail(fmt::format("wedm-{}", what), message);
            }) {}
  WedmContext(const WedmContext&) = delete;
  WedmContext& operator=(const WedmContext&) = delete;

  const ProgramSource& source;
  const ControlSettings settings;
  MotionSink& sink;
  InterpretSummary summary;
  WedmParameters parameters;
  WedmProgram program;
  std::vector<FlowFrame> levels;
  WedmState state;
  WedmVariables variables;
  WedmReader reader;
  WedmBlock block;
  OriginRecorder recorder;
  WedmReport report;
  WedmOutput output;
  WedmChain chain;
  RunWatch watch;

 private:
  /// What a loop may change: the points of the wire, and variables.
  std::vector<LoopBudget::Named> loopState() const;
};

}  // namespace proveout::nc

// The WL4 control, milling and turning: runs a program block by block (digest wl4). Block life: read
// (variables are assigned on the way), plan on a copy of the modal state, perform, commit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/flow/run_loop.h"
#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// Blocks, cycles, calls and jumps; RunLoop leads through the programs.
class Wl4Control : private FlowControl<Wl4Level> {
 public:
  /// What is referred to must outlive the control; `progress` may be null.
  Wl4Control(bool lathe, const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
             Progress* progress, const ControlHost& host);
  /// Once. Errors go to the sink; the summary says how it ended.
  InterpretSummary run();

 private:
  /// What of a block has been done when a program returns to it.
  enum class Part : std::uint8_t { kMotion, kCycle, kSubprograms };
  /// A block that has called a program, to go on behind it.
  struct Interrupted {
    Wl4Block block;
    Wl4BlockPlan plan;
    Part done;
    std::optional<OriginRecorder::Slot> fixed_cycle;  ///< of the words, behind an open cycle
  };

  Reading read() override;
  bool workOver() override;
  void refuse() override;
  Go carryOut() override;
  Go resume() override;
  Go endOfText() override;
  bool opens() override;
  bool opened() override;
  void closed(const Wl4Level& left) override;
  void recover() override;
  bool flush(ProgramEnd end) override;
  void sendEnd(const std::string& code) override;
  void tell(const char* what, const std::string& message) override;
  const SourceText& text() const override { return *c_.levels.back().program->text; }
  std::size_t line() const override { return c_.levels.back().block; }

  bool start();
  void warnOfLength(std::string_view line);
  void warnOfOrder();
  bool isOwnError(std::size_t here) const;
  Go goOn(Wl4BlockPlan& p, Part done);
  bool perform(Wl4BlockPlan& p);
  void commit(Wl4BlockPlan& p);
  Go cycles(const Wl4BlockPlan& p);
  Go flow();
  Go subprograms();
  Go call(const std::string& name, int times);
  Go jump(std::int64_t label);

  Wl4Context c_;
  RunLoop<Wl4Level> loop_;
  bool in_cycle_ = false;  ///< inside a fixed cycle: motions do not call it again
  std::vector<Interrupted> interrupted_;
};

}  // namespace proveout::nc

// What a virtual control asks of the world outside: the probe, files that programs write, the person at the
// machine. All of it is optional.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/nc/control/kept_data.h"
#include "core/path/toolpath.h"

namespace proveout {

/// Answers measuring moves from the stock as it stands after everything that the sink was sent so far.
class Probe {
 public:
  virtual ~Probe() = default;
  /// The parameter in 0..1 along `move` (of its path, see ArcGeometry) where the tool first touches the
  /// material; nothing: it touches none. `arc` is null for lines, `axis` where the tool stays along +z.
  /// Error: the stock cannot answer; the run ends with it.
  virtual Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry* arc,
                                                     const AxisSweep* axis) = 0;
};

/// Files that programs write. One is open at a time. Names are those of the program with '/' between folders,
/// checked by the control: relative, without "." and "..". Only what this run has written exists, so that
/// the same program gives the same files whenever it runs.
class ProgramOutput {
 public:
  virtual ~ProgramOutput() = default;
  virtual bool exists(const std::string& name) const = 0;
  /// Makes the file, or empties it, or with `append` goes on behind what it holds.
  virtual Status open(const std::string& name, bool append) = 0;
  virtual Status write(std::string_view bytes) = 0;
  virtual Status close() = 0;
};

/// Keeps the files in memory.
class MemoryOutput : public ProgramOutput {
 public:
  /// All files together take at most so many bytes; a write beyond is an error.
  static constexpr std::size_t kDefaultLimit = std::size_t{64} << 20;
  explicit MemoryOutput(std::size_t limit = kDefaultLimit) : limit_(limit) {}

  bool exists(const std::string& name) const override { return files_.contains(name); }
  Status open(const std::string& name, bool append) override;
  Status write(std::string_view bytes) override;
  Status close() override;

  /// By name; the file that is still open is among them.
  const std::map<std::string, std::string>& files() const { return files_; }

 private:
  std::map<std::string, std::string> files_;
  std::string* open_ = nullptr;
  std::size_t limit_;
  std::size_t size_ = 0;
};

/// What the person at the machine and the machine's PLC answer. Fixed for a run, so that it can be repeated.
struct Operator {
  /// Answer to a message box by its number: 0 closed, 1 OK, 2 yes, 3 no. Boxes not listed get OK or yes.
  std::map<int, int> message_answers;
  std::array<bool, 32> plc_bits{};      ///< inputs #1000 to #1031
  std::array<double, 3> plc_numbers{};  ///< inputs #1033 to #1035
  bool test_mode = false;               ///< #_TEST
  int date = 20000101;                  ///< YYYYMMDD
  /// What the programs before this one have left in the control (InterpretSummary::kept).
  KeptData kept;
  int time = 0;  ///< HHMMSS at the start of the program; goes on with the cycle time
};

/// Null: there is none. Without a probe measuring moves meet nothing; without an output files are written in
/// memory and lost at the end of the run.
struct ControlHost {
  Probe* probe = nullptr;
  ProgramOutput* output = nullptr;
  Operator person;
};

}  // namespace proveout

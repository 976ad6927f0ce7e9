// Where program texts come from. The interpreter does no file I/O: it asks a ProgramSource for bytes.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace proveout {

/// Where the lines of a text come from that was made of several files.
struct TextOrigins {
  struct Line {
    std::uint32_t file = 0;  ///< index into `files`
    std::uint32_t line = 0;  ///< from 1
  };
  std::vector<std::string> files;  ///< names for people; all differ
  std::vector<Line> lines;         ///< of each line of the text
};

/// One program text as it lies in its file.
struct ProgramText {
  std::string name;   ///< for people: diagnostics and the path stream ("bear.nc", "O0011.nc")
  std::string path;   ///< identity, opaque to the interpreter; handed back as `caller` in queries
  std::string bytes;  ///< raw bytes, not decoded
  std::shared_ptr<const TextOrigins> origins = nullptr;  ///< null: the lines are the file's own
};

/// What a program calls. Either `stems` or `path` is set.
struct SubprogramQuery {
  std::string caller;  ///< ProgramText::path of the calling program
  std::vector<std::string>
      stems;         ///< file names without extension in order of preference: {"O0011", "O00000011"}
  std::string path;  ///< a file as the program names it, separators turned into '/'; relative to the caller
  int system_channel = 0;  ///< above 0: `stems` lie in the folder SystemMacros/Channel<n> of the control
  /// Endings of the names of files ("", ".nc") that are looked for behind that of the caller. Empty: that of
  /// the caller only.
  std::vector<std::string> extensions = {};
};

/// The error where a program has none of the names of a query with extensions; `where` they were looked for:
/// "the folders A, B".
Error noneOf(const SubprogramQuery& query, const std::string& where);

/// "SystemMacros/Channel1/" for channel 1; empty for 0.
std::string systemFolder(int channel);

/// Finds program texts. Implementations may be asked for the same program again (the interpreter keeps
/// what it has loaded, keyed by ProgramText::path).
class ProgramSource {
 public:
  virtual ~ProgramSource() = default;
  /// The main program. Error: the file cannot be read; the message names it.
  virtual Result<ProgramText> mainProgram() const = 0;
  /// A subprogram. The nct control demands the caller's folder and extension; a source may add the
  /// folders that the job names. Error: none found; the message says what was looked for and where.
  virtual Result<ProgramText> subprogram(const SubprogramQuery& query) const = 0;
  /// Whether there is a program of that name, be it one that subprogram() refuses: no other may take its
  /// place.
  virtual bool finds(const SubprogramQuery& query) const { return subprogram(query).ok(); }
};

/// Programs in memory, for tests and for callers that have the text already. Stems are matched without
/// regard to case and extension; paths by their last part. System programs have their folder in the name
/// ("SystemMacros/Channel1/O9010.nct").
class MemoryProgramSource : public ProgramSource {
 public:
  MemoryProgramSource(std::string main_name, std::string main_bytes);
  /// Adds a subprogram under its file name ("O0011.nc" or "O0011").
  void add(const std::string& name, std::string bytes);
  Result<ProgramText> mainProgram() const override;
  Result<ProgramText> subprogram(const SubprogramQuery& query) const override;

 private:
  ProgramText main_;
  std::vector<ProgramText> subprograms_;
};

}  // namespace proveout

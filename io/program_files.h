// NC programs from the file system.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/nc/program_source.h"

namespace proveout {

/// Finds the main program and what it calls. File names are matched without regard to case, as controls with
/// DOS and Windows file systems do; where several files match, the one that sorts first is taken, an exact
/// match before it.
///
/// A subprogram by name ("O0011") is looked for
///  1. in the folder of the calling program, with that program's extension;
///  2. among the files and folders that the job names, in their order: with the calling program's extension,
///  then
///     with any other of programExtensions(), then with none.
/// A subprogram by path is looked for relative to the folder of the calling program, then in the job's
/// folders. A system program is looked for in SystemMacros/Channel<n> beside the main program, beside its
/// folder and in the job's folders, then among the job's files and folders themselves. Files are read anew at
/// each call; nothing is cached.
class FileProgramSource : public ProgramSource {
 public:
  /// `places`: files and folders with subprograms.
  explicit FileProgramSource(std::string main_path, std::vector<std::string> places = {});
  Result<ProgramText> mainProgram() const override;
  Result<ProgramText> subprogram(const SubprogramQuery& query) const override;

  static const std::vector<std::string>& programExtensions();  ///< ".nc", ".txt", ... lower case

  /// Larger programs are refused: they are not programs.
  static constexpr std::size_t kMaxProgramBytes = std::size_t{1} << 30;

 private:
  std::string findByStem(const std::string& caller, const std::string& stem) const;
  std::string findSystem(const std::string& stem, int channel) const;
  std::string findByPath(const std::string& caller, const std::string& path) const;

  std::string main_path_;
  std::vector<std::string> places_;
};

}  // namespace proveout

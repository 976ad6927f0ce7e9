// NC programs from the file system.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/nc/control/program_source.h"
#include "io/program_reach.h"

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
///
/// Names come from the text of programs, so that they open nothing but what lies, links followed, in the
/// folder of the main program, in those that the job names, or beside a file that it names and that calls.
/// What leads out of these is refused without being read.
class FileProgramSource : public ProgramSource {
 public:
  /// `places`: files and folders with subprograms.
  explicit FileProgramSource(std::string main_path, std::vector<std::string> places = {});
  Result<ProgramText> mainProgram() const override;
  Result<ProgramText> subprogram(const SubprogramQuery& query) const override;
  bool finds(const SubprogramQuery& query) const override;

  static const std::vector<std::string>& programExtensions();  ///< ".nc", ".txt", ... lower case

  /// Larger programs are refused: they are not programs.
  static constexpr std::size_t kMaxProgramBytes = std::size_t{1} << 30;

 private:
  struct Found {
    std::string path = {};  ///< empty: nowhere
    bool outside = false;   ///< the name leads out of the folders
  };
  const std::string& callerOf(const SubprogramQuery& query) const {
    return query.caller.empty() ? main_path_ : query.caller;
  }
  Found find(const SubprogramQuery& query) const;
  Found findByStem(const std::string& caller, const std::string& stem) const;
  Found findWithExtension(const std::string& caller, const std::string& stem,
                          const std::string& extension) const;
  Found findSystem(const std::string& stem, int channel) const;
  Found findByPath(const std::string& caller, const std::string& path) const;
  std::vector<std::filesystem::path> filesAt(const std::string& place) const;
  std::vector<std::filesystem::path> systemFolders(int channel) const;
  ProgramReach reachFrom(const std::string& caller) const;
  Error outside(const std::string& name) const;
  Error missing(const SubprogramQuery& query, const std::string& caller) const;

  std::string main_path_;
  std::vector<std::string> places_;
};

}  // namespace proveout

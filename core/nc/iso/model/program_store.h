// The program texts of a run, loaded once each.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/text/program_heads.h"
#include "core/nc/text/source_text.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// How programs lie in files.
enum class ProgramLayout : std::uint8_t {
  kOneInAFile,     ///< subprograms are files of their own
  kSeveralInAFile  ///< a program ends where the next O number stands; calls look in their own file first
};

/// Texts by index; the index is the file index of the path, and of each program behind the first of a file.
/// Each channel has a store.
class ProgramStore {
 public:
  ProgramStore(const ProgramSource& source, TextEncoding encoding, ProgramLayout layout, MotionSink& sink)
      : source_(source), encoding_(encoding), layout_(layout), sink_(sink) {}

  enum class Failure { kNone, kNotFound, kEncoding };
  struct Loaded {
    SourceText* text = nullptr;
    std::uint32_t file = 0;
    Failure failure = Failure::kNone;
    std::string message;    ///< why there is no text
    std::size_t again = 0;  ///< line of its file, from 1, where another program of the number begins; 0: none
  };
  Loaded main();
  /// Program `number` (M98 P, G65 P, system calls: "O0011", "O00000011") as seen from file `caller`. The
  /// answer is kept: a second call of the same number builds no string.
  /// `folders_first`: other programs of the caller's file come last.
  Loaded byNumber(std::uint32_t caller, std::int64_t number, bool folders_first = false);
  /// Program `number` of the channel's system macros ("O9010"); with several programs in a file they lie
  /// where all programs do.
  Loaded system(std::int64_t number, int channel);
  /// A program that is part of the control; `name` is its path too.
  Loaded builtIn(const std::string& name, std::string_view text);
  /// A program by the name of its file without extension, as seen from file `caller`.
  Loaded byStem(std::uint32_t caller, const std::string& stem);
  /// A file as the program names it, separators '/', relative to the caller.
  Loaded byPath(std::uint32_t caller, const std::string& path);

  const SourceText& text(std::uint32_t file) const { return *texts_[file]; }
  std::size_t size() const { return texts_.size(); }

 private:
  Loaded load(const Result<ProgramText>& text);
  Loaded keep(std::unique_ptr<SourceText> text);
  Loaded inFile(const std::string& path, std::int64_t number, std::string_view name = {});
  Loaded known(std::uint32_t file) const { return {texts_[file].get(), file, Failure::kNone, {}}; }

  const ProgramSource& source_;
  TextEncoding encoding_;
  ProgramLayout layout_;
  MotionSink& sink_;
  /// A file whose programs have heads.
  struct File {
    std::unique_ptr<SourceText> text;  ///< of all of them; null: there is one
    std::vector<ProgramHead> heads;
  };
  std::vector<std::unique_ptr<SourceText>> texts_;
  std::unordered_map<std::string, File> files_;  ///< by path
  std::unordered_map<std::string, std::uint32_t> by_path_;
  std::unordered_map<std::uint64_t, std::uint32_t> by_number_;  ///< caller and number -> file
  std::unordered_map<std::string, std::uint32_t> by_name_;      ///< caller and path -> file
};

}  // namespace proveout::nc

// Programs with one place put otherwise.
#pragma once

#include <cstdint>
#include <string>

#include "app/session/programs/interpretation.h"

namespace proveout {

/// Columns of a line are replaced by `text`.
struct TextChange {
  std::string file;          ///< as in Toolpath::files
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t begin = 0;   ///< column from 1, bytes of the UTF-8 line
  std::uint32_t length = 0;  ///< 0: `text` is put in
  std::string text;
};

/// Passes programs on as UTF-8, with a change. `inner` must outlive this.
class ChangedSource : public ProgramSource {
 public:
  /// `encoding`: of what `inner` gives.
  ChangedSource(const ProgramSource& inner, TextEncoding encoding, TextChange change);
  Result<ProgramText> mainProgram() const override { return changed(inner_.mainProgram()); }
  Result<ProgramText> subprogram(const SubprogramQuery& query) const override {
    return changed(inner_.subprogram(query));
  }
  bool finds(const SubprogramQuery& query) const override { return inner_.finds(query); }

 private:
  Result<ProgramText> changed(Result<ProgramText> text) const;

  const ProgramSource& inner_;
  TextEncoding encoding_;
  TextChange change_;
};

}  // namespace proveout

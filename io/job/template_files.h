// Programs from template files.
#pragma once

#include <string>
#include <vector>

#include "core/nc/text/template_set.h"
#include "io/job/job.h"
#include "io/program_files.h"

namespace proveout {

/// Reads the template or set at `path` and fills it; templates of a set lie beside it. Errors go to
/// `diagnostics`.
std::optional<nc::FilledProgram> fillFile(const std::string& path, const TemplateUse& use,
                                          Diagnostics& diagnostics);

/// Makes the job's program a template or set that is filled with its defaults. Errors go to `diagnostics`.
void fillWithDefaults(const std::string& path, Job& job, Diagnostics& diagnostics);

/// The main program is a filled template or set, as UTF-8, under the name of its file; subprograms are files.
class TemplateProgramSource : public ProgramSource {
 public:
  TemplateProgramSource(std::string path, TemplateUse use, std::vector<std::string> places)
      : path_(path), use_(std::move(use)), files_(std::move(path), std::move(places)) {}
  Result<ProgramText> mainProgram() const override;
  Result<ProgramText> subprogram(const SubprogramQuery& query) const override {
    return files_.subprogram(query);
  }
  bool finds(const SubprogramQuery& query) const override { return files_.finds(query); }

 private:
  std::string path_;
  TemplateUse use_;
  FileProgramSource files_;
};

}  // namespace proveout

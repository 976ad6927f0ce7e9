// Programs made of templates: one template with its values, or a set of them.
//
// The shell's set (.tmps) is a list of templates with their values and of pieces of program text. As text it
// is a program in which a line
//   @ NAME.tmpl D=40;d1=25
// stands for the filled template; a NAME with blanks stands in quotes. All other lines are program text,
// which may have parameters of its own.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/text/template_text.h"

namespace proveout::nc {

/// Finds the template that a set names.
using TemplateLoader = std::function<Result<ProgramText>(const std::string& name)>;

/// Whether a file name's extension is one of templates or sets: .tmpl, .tmps.
bool isTemplateName(std::string_view name);

struct FilledProgram {
  std::vector<std::string> lines;
  /// A template of a set has a name for each of its uses, "cone.tmpl (part.tmps:4)", since its lines differ.
  TextOrigins origins;
  std::vector<ProgramText> files;  ///< as read: the main file, then templates in order of first use

  std::string text() const;  ///< lines with their ends
};

/// The program of a template or a set. Errors, each with its place: those of readTemplate(), refusalOf() and
/// fillTemplate(), of a set also templates that are not found and sets within sets.
std::optional<FilledProgram> fillProgram(const ProgramText& main, const TemplateValues& values,
                                         const TemplateLoader& load, TextEncoding encoding,
                                         Diagnostics& diagnostics);

}  // namespace proveout::nc

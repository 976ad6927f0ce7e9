// Templates of the FlexNC shell as text: a program in which [name] stands for a number that is filled in.
//
// The manual tells what stands in the text; how a parameter's meaning, default and range are kept it does
// not, since its files are containers of the shell. Here they are comment lines of their own,
//   //@ [D] = 40, 10..200: diameter of the bar, mm
// of which everything behind the name may be left out. These lines are no part of the program.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"

namespace proveout::nc {

/// Largest template, bytes, and largest program that comes out of one.
inline constexpr std::size_t kMaxTemplateBytes = std::size_t{16} << 20;
inline constexpr std::size_t kMaxFilledBytes = std::size_t{256} << 20;
/// So many errors are told of one.
inline constexpr int kMostTemplateErrors = 20;

struct TemplateParameter {
  std::string name;                  ///< without brackets; any characters but brackets, case counts
  std::string meaning;               ///< empty: not told
  std::optional<std::string> value;  ///< default, a number
  std::optional<double> min, max;
  SourceLocation where;  ///< of its declaration, else of its first use
  bool used = false;
};

using TemplateValues = std::map<std::string, std::string>;

struct Template {
  std::string name;                ///< for people
  std::vector<std::string> lines;  ///< UTF-8, index 0 is line 1
  std::vector<TemplateParameter> parameters;

  const TemplateParameter* find(const std::string& parameter) const;
  std::vector<std::string> names() const;
};

/// Reads a template. Errors, each with its place: a container of the shell (binary: export it as .pmc), text
/// in another encoding, brackets without partner or name, two declarations of a name, bad defaults and
/// ranges.
std::optional<Template> readTemplate(const ProgramText& text, TextEncoding encoding,
                                     Diagnostics& diagnostics);

/// Why the template does not take this value: no such parameter (with the nearest name), no number, empty,
/// out of range. Empty: it does.
std::string refusalOf(const Template& text, const std::string& parameter, const std::string& value);

/// The program, one line for each line of the template, so that numbers of lines stay: declarations become
/// empty lines. All values must have passed refusalOf(). Errors: a parameter without value (with its place),
/// a program that gets too large.
std::optional<std::vector<std::string>> fillTemplate(const Template& text, const TemplateValues& values,
                                                     Diagnostics& diagnostics);

}  // namespace proveout::nc

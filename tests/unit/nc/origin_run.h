// A program that has run, and what its origins say in one line of text.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/registry/interpreter.h"
#include "core/nc/text/source_text.h"
#include "core/path/origin_query.h"

namespace proveout::test {

class OriginRun {
 public:
  using Programs = std::vector<std::pair<std::string, std::string>>;

  Toolpath path;
  InterpretSummary summary;

  explicit OriginRun(const std::string& text, const ControlSettings& settings = {},
                     const Programs& others = {}, ControlId control = ControlId::kNct) {
    MemoryProgramSource source("main.nc", text);
    keep("main.nc", text);
    for (const auto& [name, bytes] : others) {
      source.add(name, bytes);
      keep(name, bytes);
    }
    ControlSettings from_zero = settings;
    if (from_zero.start == ControlSettings().start) from_zero.start = Vec3::Zero();
    ToolpathBuilder sink(path);
    summary = interpret(control, source, from_zero, sink);
  }

  LineText text() const {
    return [this](std::uint32_t file, std::uint32_t line) {
      const auto lines = lines_.find(path.files.at(file));
      if (lines == lines_.end() || line < 1 || line > lines->second.size()) return std::string();
      return lines->second[line - 1];
    };
  }

  /// The n-th motion, from 0, of that line of the main program.
  MotionId motionOf(std::uint32_t line, std::size_t n = 0, std::uint32_t file = 0) const {
    for (MotionId id = 0; id < path.motions.size(); ++id) {
      const SourceRef& source = path.motions[id].source;
      if (source.line == line && source.file == file && n-- == 0) return id;
    }
    return kNoMotion;
  }

  /// "6 Z-3.5"; words of other files "O10.nc:6 Z-3.5"; steps "6 Z-3.5 step"; computed words
  /// "9 Z#101 <- [4 #101=-3]". Empty: the program never said it.
  std::string said(MotionId motion, OriginKind kind) const {
    if (motion >= path.motions.size()) return "no such motion";
    const auto origin = originOf(path, motion, kind, text());
    return origin ? shown(*origin) : "";
  }
  /// The same of a word by its number.
  std::string saidBy(std::uint32_t number) const {
    const auto origin = originOfWord(path, number, text());
    return origin ? shown(*origin) : "";
  }
  double valueOf(MotionId motion, OriginKind kind) const {
    return originOf(path, motion, kind, text()).value().value;
  }
  MotionId last() const { return static_cast<MotionId>(path.motions.size() - 1); }

  std::string shown(const ResolvedOrigin& origin) const {
    const std::string file = origin.file == 0 ? "" : path.files[origin.file] + ":";
    std::string out = fmt::format("{}{} {}", file, origin.line, origin.text);
    if (origin.incremental) out += " step";
    for (const ResolvedOrigin& from : origin.from) out += fmt::format(" <- [{}]", shown(from));
    return out;
  }

 private:
  void keep(const std::string& name, const std::string& bytes) {
    const nc::SourceText source(name, name, bytes);
    lines_[name].assign(source.lines().begin(), source.lines().end());
  }
  std::map<std::string, std::vector<std::string>> lines_;
};

}  // namespace proveout::test

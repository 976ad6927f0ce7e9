// Programs with known words, and what becomes wrong with a part when one of them is.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"

namespace proveout::study {

/// What is planted: values of words or data by name, features that are left out.
struct Plan {
  std::map<std::string, double> values;      ///< instead of what is right
  std::map<std::string, std::string> texts;  ///< words written otherwise: "T7" for "T2"
  std::set<std::string> dropped;
  double of(const std::string& name, double right) const {
    const auto at = values.find(name);
    return at == values.end() ? right : at->second;
  }
  std::string text(const std::string& name, const std::string& right) const {
    const auto at = texts.find(name);
    return at == texts.end() ? right : at->second;
  }
};

/// Writes a program and remembers the lines of named words.
class Writer {
 public:
  explicit Writer(const Plan& plan) : plan_(plan) {}
  Writer& word(const std::string& letter, const std::string& name, double right) {
    lines_[name] = line_;
    return put(letter + number(plan_.of(name, right)));
  }
  Writer& text(const std::string& name, const std::string& right) {
    lines_[name] = line_;
    return put(plan_.text(name, right));
  }
  Writer& put(const std::string& words) {
    if (!now_.empty()) now_ += " ";
    now_ += words;
    return *this;
  }
  void end() {
    program_ += now_ + "\n";
    now_.clear();
    ++line_;
  }
  void block(const std::string& words) { put(words).end(); }
  bool has(const std::string& feature) {
    features_.emplace(feature, line_);
    return !plan_.dropped.contains(feature);
  }
  const std::string& program() const { return program_; }
  /// 0: there is none.
  int lineOf(const std::string& name) const {
    const auto at = lines_.find(name);
    return at == lines_.end() ? 0 : at->second;
  }
  /// Where a feature begins, or would.
  int beginOf(const std::string& feature) const {
    const auto at = features_.find(feature);
    return at == features_.end() ? 0 : at->second;
  }
  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", value);
    std::string out = text;
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
    return out;
  }

 private:
  const Plan& plan_;
  std::string program_, now_;
  int line_ = 1;
  std::map<std::string, int> lines_, features_;
};

/// A program, its job and where the words are.
struct Planted {
  std::string program, job;
  std::map<std::string, int> lines;
};

/// A defect, and what should be told of it.
struct Defect {
  std::string kind;  ///< "Z", "H row" ...: a line of the table
  Plan plan;
  double size = 0.0;  ///< how far the word or datum is off, mm
  /// Deepest point of the part, mm, where a closed form is known: distance of one surface from the other.
  std::optional<double> depth;
  std::set<std::string> words;  ///< names of the words of which one has to be named
  std::set<std::string> data;   ///< keys of the job of which one has to be named
  bool missing = false;         ///< nothing was cut: that is to be told
};

/// A part with its programs and defects.
struct StudyPart {
  std::string name;
  std::function<Planted(const Plan&, int habit)> write;  ///< habit 0 is the one that defects are planted in
  std::function<TriMesh(double chord)> nominal;
  std::function<Defect(std::mt19937&)> defect;
};

StudyPart milledPart();
StudyPart turnedPart();

/// Size between `least` and `most`, even on a logarithmic scale, either sign; of as many digits as `number`
/// writes, since what is cut is what is written.
inline double signedSize(std::mt19937& random, double least, double most) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double size = std::round(1e4 * least * std::pow(most / least, unit(random))) / 1e4;
  return random() % 2 == 0 ? size : -size;
}

}  // namespace proveout::study

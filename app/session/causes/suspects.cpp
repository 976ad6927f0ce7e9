#include "app/session/causes/suspects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "app/session/causes/job_data.h"
#include "app/session/findings/blame.h"
#include "core/tool/tool_table.h"

namespace proveout {

namespace {

using enum OriginKind;

/// Codes of which one is in force at a time; what is written in the place of another one.
constexpr std::array<std::string_view, 6> kGroups[] = {
    {"G2", "G3"},   {"G17", "G18", "G19"}, {"G40", "G41", "G42"}, {"G43", "G44", "G49"},
    {"G90", "G91"}, {"G98", "G99"},        {"G20", "G21"},        {"G68", "G69"},
    {"G15", "G16"}, {"G50", "G51", "G52"}, {"G1", "G2", "G3"},    {"G54", "G55", "G56", "G57", "G58", "G59"},
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// A letter and a whole number: "G02" is G2.
struct Code {
  char letter;
  int number;
  std::size_t digits;  ///< written
};

std::optional<Code> codeIn(std::string_view text) {
  if (text.size() < 2 || text[0] < 'A' || text[0] > 'Z') return std::nullopt;
  if (!std::all_of(text.begin() + 1, text.end(), isDigit)) return std::nullopt;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return Code{text[0], number, text.size() - 1};
}

std::string written(const Code& like, int number) {
  return fmt::format("{}{:0{}}", like.letter, number, std::max<std::size_t>(like.digits, 1));
}

/// What the number of a word is and where in its text: "#101=-3" has -3.
struct Literal {
  std::size_t begin;
  double value;
  bool point;
};

std::optional<Literal> literalIn(const std::string& text) {
  std::size_t begin = text.size();
  while (begin > 0 && (isDigit(text[begin - 1]) || text[begin - 1] == '.')) --begin;
  if (begin == text.size() || begin == 0) return std::nullopt;
  if (text[begin - 1] == '#') return std::nullopt;  // a variable
  if (text[begin - 1] == '-' || text[begin - 1] == '+') --begin;
  if (begin == 0) return std::nullopt;
  const char before = text[begin - 1];
  if (!(before == '=' || before == ' ' || (before >= 'A' && before <= 'Z') || before == ','))
    return std::nullopt;
  Literal out{begin, 0.0, text.find('.', begin) != std::string::npos};
  const std::size_t from = text[begin] == '+' ? begin + 1 : begin;
  const auto [end, error] = std::from_chars(text.data() + from, text.data() + text.size(), out.value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

/// A number as programs and jobs write it.
std::string plain(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

TextChange changeOf(const Toolpath& path, const ResolvedOrigin& word, std::string text) {
  return {path.files[word.file], word.line, word.begin, static_cast<std::uint32_t>(word.text.size()),
          std::move(text)};
}

bool isNumeric(OriginKind kind) {
  switch (kind) {
    case kX:
    case kY:
    case kZ:
    case kU:
    case kV:
    case kW:
    case kA:
    case kOtherAxis:
    case kI:
    case kJ:
    case kK:
    case kArcRadius:
    case kAngle:
    case kCorner:
    case kCycleDepth:
    case kCyclePlane:
    case kCycleStep:
    case kCycleShift:
    case kAllowance:
    case kThreadLead:
    case kVariable:
    case kArgument:
    case kData:
    case kShift:
      return true;
    default:
      return false;
  }
}

Suspect bare(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& word) {
  const Toolpath& path = scene.run.setups[setup].interpreted.path;
  Suspect out;
  out.setup = setup;
  out.key = fmt::format("{}:{}:{}:{}", setup, word.file, word.line, word.begin);
  out.cause.what = originKindName(word.kind);
  out.cause.value = word.text;
  out.cause.source = blockRef(path, word, *scene.sources[setup]);
  out.cause.column = word.begin;
  out.cause.incremental = word.incremental;
  for (const ResolvedOrigin& from : word.from)
    out.cause.from.push_back(blockRef(path, from, *scene.sources[setup]));
  return out;
}

void addOther(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& word,
              const std::string& text, Suspect& out) {
  const Toolpath& path = scene.run.setups[setup].interpreted.path;
  out.others.push_back({text, Trial{setup, changeOf(path, word, text), nullptr}});
}

void addCodes(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& word, const Code& code,
              Suspect& out) {
  const std::string name = fmt::format("{}{}", code.letter, code.number);
  for (const auto& group : kGroups) {
    if (std::find(group.begin(), group.end(), name) == group.end()) continue;
    for (const std::string_view other : group) {
      if (other.empty() || other == name) continue;
      const Code as = *codeIn(other);
      const bool system = as.number >= 54 && as.number <= 59;
      if (system &&
          !scene.run.setups[setup].job.settings.work_given[static_cast<std::size_t>(as.number - 54)])
        continue;
      addOther(scene, setup, word, written(code, as.number), out);
    }
  }
}

/// Rows of a table, or numbers of tools, besides the one that is called.
void addRows(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& word, const Code& code,
             Suspect& out) {
  constexpr std::size_t kMostOthers = 6;
  std::vector<int> rows;
  const Job& job = scene.run.setups[setup].job;
  if (code.letter == 'T') {
    for (const Tool& tool : job.tools) rows.push_back(tool.number);
  } else {
    for (const auto& row : code.letter == 'D' ? job.settings.radius_offsets : job.settings.length_offsets)
      rows.push_back(row.first);
  }
  for (const int row : rows) {
    if (row != code.number && out.others.size() < kMostOthers)
      addOther(scene, setup, word, written(code, row), out);
  }
}

}  // namespace

std::optional<Suspect> suspectWord(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& word,
                                   double off_mm) {
  if (word.begin == 0 || word.text.empty()) return std::nullopt;
  const Toolpath& path = scene.run.setups[setup].interpreted.path;
  if (!scene.sources[setup]->has(path.files[word.file])) return std::nullopt;
  Suspect out = bare(scene, setup, word);
  if (isNumeric(word.kind)) {
    const auto literal = literalIn(word.text);
    if (!literal) return std::nullopt;
    out.value = literal->value;
    // Without a point the control may count in increments.
    const bool scaled = std::isfinite(word.value) && word.value != 0.0 && literal->value != 0.0;
    const double scale = scaled ? literal->value / word.value : 1.0;
    out.first_step = -off_mm * scale;
    out.per_mm = scale;
    out.decimals = scale > 10.0 ? 0 : 3;
    const std::string head = word.text.substr(0, literal->begin);
    const bool point = literal->point;
    const int decimals = out.decimals;
    out.text = [head, point, decimals](double value) {
      std::string number = plain(value, decimals);
      if (point && number.find('.') == std::string::npos) number += '.';
      return head + number;
    };
    out.put = [&path, word, setup, text = out.text](double value) -> std::optional<Trial> {
      return Trial{setup, changeOf(path, word, text(value)), nullptr};
    };
    return out;
  }
  const auto code = codeIn(word.text);
  if (!code) return std::nullopt;
  if (code->letter == 'G') addCodes(scene, setup, word, *code, out);
  if (code->letter == 'D' || code->letter == 'H' || code->letter == 'T')
    addRows(scene, setup, word, *code, out);
  if (out.others.empty()) return std::nullopt;
  return out;
}

namespace {

/// What tools are sold with, and what people enter: rows of D are mostly a tool's radius, work offsets where
/// the workpiece lies, H 0 or a gauge length.
void addUsual(const SuspectScene& scene, std::uint32_t setup, const std::string& key, Suspect& out) {
  const Job& job = scene.run.setups[setup].job;
  const auto add = [&](double value) {
    if (value != out.value && std::find(out.usual.begin(), out.usual.end(), value) == out.usual.end())
      out.usual.push_back(value);
  };
  if (key.starts_with("offsets.radius.")) {
    for (const Tool& tool : job.tools) add(0.5 * tool.diameter);
  } else if (key.starts_with("offsets.length.")) {
    add(0.0);
    for (const Tool& tool : job.tools) add(tool.gauge_length);
  } else if (key.starts_with("offsets.work.") && job.settings.placement.origin) {
    add((*job.settings.placement.origin)[key.back() - 'x'] - job.settings.common_offset[key.back() - 'x']);
  } else if (key.ends_with(".corner_radius")) {
    out.least = 0.0;
    out.most = std::numeric_limits<double>::infinity();
    add(0.0);
  } else if (key.ends_with(".cone_angle")) {
    for (const double angle : {90.0, 60.0, 82.0, 120.0, 100.0}) add(angle);
  } else if (key.ends_with(".point_angle")) {
    for (const double angle : {118.0, 140.0, 90.0, 120.0, 130.0, 135.0}) add(angle);
  } else if (key.ends_with(".diameter")) {  // as the row of its number says
    constexpr double kAlike = 0.3;
    const auto row =
        job.settings.radius_offsets.find(std::atoi(key.c_str() + std::string_view("tools.").size()));
    const double twice =
        row == job.settings.radius_offsets.end() ? 0.0 : 2.0 * (row->second.geometry + row->second.wear);
    if (std::abs(twice - out.value) <= kAlike * out.value) add(twice);
  }
}

}  // namespace

std::optional<Suspect> suspectDatum(const SuspectScene& scene, std::uint32_t setup, const std::string& key,
                                    double off_mm) {
  const auto value = jobNumber(scene.job, setup, key);
  if (!value) return std::nullopt;
  Suspect out;
  out.setup = setup;
  out.key = fmt::format("{}:{}", setup, key);
  out.cause.what = key;
  out.cause.value = fmt::format("{:g}", *value);
  out.value = *value;
  out.first_step = -off_mm;
  if (key.starts_with("tools.") && *value > 0.0) {
    // Another tool of the kind; farther off it is not this datum that is wrong.
    constexpr double kTimes = 2.0;
    out.least = *value / kTimes;
    out.most = *value * kTimes;
  }
  constexpr double kDegreesPerMm = 10.0;
  if (key.ends_with("_angle")) out.per_mm = kDegreesPerMm;
  addUsual(scene, setup, key, out);
  out.text = [key](double v) { return fmt::format("{} = {}", key, plain(v, 4)); };
  out.put = [key, setup](double v) -> std::optional<Trial> {
    Trial trial;
    trial.setup = setup;
    trial.datum = [key, setup, v](Job& job) { return putJobNumber(job, setup, key, v); };
    return trial;
  };
  return out;
}

namespace {

/// A letter with its number in a line, outside of comments.
struct LineWord {
  std::size_t begin;
  std::string text;
};

std::vector<LineWord> wordsIn(const std::string& line) {
  std::vector<LineWord> out;
  int comment = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    comment += line[i] == '(' ? 1 : line[i] == ')' ? -1 : 0;
    if (comment > 0 || line[i] < 'A' || line[i] > 'Z') continue;
    std::size_t end = i + 1;
    if (end < line.size() && (line[end] == '-' || line[end] == '+')) ++end;
    while (end < line.size() && (isDigit(line[end]) || line[end] == '.')) ++end;
    // A row of the offset table and its value are one: "H001=110".
    if (end < line.size() && line[end] == '=') {
      ++end;
      while (end < line.size() && (isDigit(line[end]) || line[end] == '.' || line[end] == '-')) ++end;
    }
    if (end > i + 1) out.push_back({i, line.substr(i, end - i)});
    i = end - 1;
  }
  return out;
}

/// A word of a line as an origin, which the block has recorded as a whole or in another word.
ResolvedOrigin wordAt(const ResolvedOrigin& block, const LineWord& w, OriginKind kind) {
  ResolvedOrigin word = block;
  word.kind = kind;
  word.begin = static_cast<std::uint16_t>(w.begin + 1);
  word.text = w.text;
  word.value = std::numeric_limits<double>::quiet_NaN();
  return word;
}

/// The count of repeats in a line, L, or the place behind the call where one could stand.
void addRepeats(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& block,
                std::vector<Suspect>& out) {
  const Toolpath& path = scene.run.setups[setup].interpreted.path;
  const std::string line = scene.sources[setup]->line(path.files[block.file], block.line);
  for (const LineWord& w : wordsIn(line)) {
    const auto code = codeIn(w.text);
    if (!code || (code->letter != 'L' && code->letter != 'K') || code->number > 999) continue;
    const ResolvedOrigin word = wordAt(block, w, block.kind);
    Suspect repeats = bare(scene, setup, word);
    repeats.cause.what = "repeats";
    for (const int more : {1, -1, 2, -2}) {
      if (code->number + more >= 1)
        addOther(scene, setup, word, written(*code, code->number + more), repeats);
    }
    out.push_back(std::move(repeats));
  }
}

void addWord(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& word, double step,
             std::vector<Suspect>& out) {
  if (auto suspect = suspectWord(scene, setup, word, step)) out.push_back(std::move(*suspect));
  for (const ResolvedOrigin& from : word.from) addWord(scene, setup, from, step, out);
}

/// What a word of a wire's program says, as a modal one; empty: nothing that shifts a cut.
std::string_view wireWord(const std::string& text) {
  if (text.find('=') != std::string::npos) return text[0] == 'H' ? "offset value" : "";
  if (text[0] == 'A') return "taper angle";
  if (text[0] == 'H') return "offset row";
  if (text[0] == 'T') return "upper plane";
  const auto code = codeIn(text);
  if (!code || code->letter != 'G') return "";
  if (code->number >= 40 && code->number <= 42) return "side of the offset";
  if (code->number >= 50 && code->number <= 52) return "side of the taper";
  return "";
}

/// The wire whose radius and the gap are this offset: one of those that are sold, and not the tool's.
std::optional<double> fittingWire(const Tool& tool, double offset_mm) {
  constexpr double kFits = 1e-6;
  for (const double diameter : {0.25, 0.2, 0.3, 0.15, 0.1}) {
    if (std::abs(0.5 * diameter + tool.spark_gap - offset_mm) < kFits &&
        std::abs(diameter - tool.diameter) > kFits)
      return diameter;
  }
  return std::nullopt;
}

/// Wires' controls do not tell which modal words a motion was made with: those that stand last before it in
/// its file. Returns the diameter of the wire that the row in force is made for, where that is another one
/// than the job's.
std::optional<double> addWireWords(const SuspectScene& scene, std::uint32_t setup, const SourceRef& at,
                                   const Tool* tool, double depth_mm, std::vector<Suspect>& out) {
  constexpr std::uint32_t kMostLines = 5000;
  constexpr double kPerMm = 1000.0;  // rows of offsets count micrometres
  const Toolpath& path = scene.run.setups[setup].interpreted.path;
  std::optional<double> fitting;
  std::vector<std::string> known;
  for (std::uint32_t line = at.line; line > 0 && at.line - line < kMostLines; --line) {
    for (const LineWord& w : wordsIn(scene.sources[setup]->line(path.files[at.file], line))) {
      const std::string what(wireWord(w.text));
      if (what.empty() || std::find(known.begin(), known.end(), what) != known.end()) continue;
      known.push_back(what);
      ResolvedOrigin block;
      block.file = at.file;
      block.line = line;
      const bool number = what == "taper angle" || what == "offset value" || what == "upper plane";
      auto suspect = suspectWord(scene, setup, wordAt(block, w, number ? kData : kCompensation), 0.0);
      if (!suspect) continue;
      suspect->cause.what = what;
      suspect->first_step = 1.0;
      if (what == "offset value") {
        suspect->first_step = kPerMm * depth_mm;
        suspect->per_mm = kPerMm;
        suspect->decimals = 0;
        if (tool != nullptr) fitting = fittingWire(*tool, suspect->value / kPerMm);
        // A value that another wire has to the micrometre is right, and the wire is not.
        if (tool != nullptr && !fitting)
          suspect->usual = {std::round(kPerMm * (0.5 * tool->diameter + tool->spark_gap))};
      }
      if (what == "taper angle" && suspect->value != 0.0) suspect->usual = {-suspect->value};
      out.push_back(std::move(*suspect));
    }
  }
  // Codes are changed before numbers: a slip of one digit of a code is the commoner one, and there are few.
  std::stable_partition(out.begin(), out.end(), [](const Suspect& s) { return !s.others.empty(); });
  return fitting;
}

/// The zero that was entered, where the workpiece lies elsewhere: wires' controls do not tell the offset in
/// force.
void addZero(const SuspectScene& scene, std::uint32_t setup, std::vector<Suspect>& out) {
  const ControlSettings& settings = scene.run.setups[setup].job.settings;
  const Vec3 off = workpieceZero(settings) - offsetZero(settings);
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (off[k] == 0.0) continue;
    const std::string key = fmt::format("offsets.work.G54.{}", "xyz"[k]);
    if (auto suspect = suspectDatum(scene, setup, key, -off[k])) out.insert(out.begin(), std::move(*suspect));
  }
}

/// The planes of a wire's control that the job gives: leaning walls turn about one of them.
void addPlanes(const SuspectScene& scene, std::uint32_t setup, std::vector<Suspect>& out) {
  const SetupRun& run = scene.run.setups[setup];
  const Box3 bounds = meshBounds(run.surface.mesh);
  for (const char* const plane : {"ZM", "ZS"}) {
    if (bounds.empty() || !run.job.settings.parameters.contains(plane)) continue;
    auto suspect = suspectDatum(scene, setup, fmt::format("control.{}.{}", run.job.control, plane), 1.0);
    if (!suspect) continue;
    // At a face of the workpiece or not at all: any other height would make up for a wrong offset somewhere.
    for (const double height : {bounds.min.z(), bounds.max.z()}) {
      const auto trial = suspect->put(height);
      if (std::abs(height - suspect->value) > 1e-9 && trial)
        suspect->others.push_back({suspect->text(height), *trial});
    }
    suspect->put = nullptr;
    out.push_back(std::move(*suspect));
  }
}

/// The numbers of the block that turned, scaled or mirrored what a motion goes along: only its code is an
/// origin.
void addTransformWords(const SuspectScene& scene, std::uint32_t setup,
                       const std::vector<ResolvedOrigin>& words, double depth_mm, std::vector<Suspect>& out) {
  constexpr double kDegreesPerMm = 3.0;  // about 20 mm from the centre
  const Toolpath& path = scene.run.setups[setup].interpreted.path;
  for (const ResolvedOrigin& code : words) {
    const bool rotates = code.kind == kRotation;
    if ((!rotates && code.kind != kScaling && code.kind != kMirror) || code.begin == 0) continue;
    for (const LineWord& w : wordsIn(scene.sources[setup]->line(path.files[code.file], code.line))) {
      if (std::string_view("GMNOT").find(w.text[0]) != std::string_view::npos) continue;
      auto suspect = suspectWord(scene, setup, wordAt(code, w, kData), depth_mm);
      if (!suspect) continue;
      suspect->cause.what = fmt::format("{} of {}", w.text[0], code.text);
      if (rotates && w.text[0] == 'R') {
        suspect->per_mm = kDegreesPerMm;
        suspect->first_step = kDegreesPerMm * depth_mm;
        for (const double angle : {0.0, -suspect->value}) {
          if (angle != suspect->value) suspect->usual.push_back(angle);
        }
      }
      out.push_back(std::move(*suspect));
    }
  }
}

/// The rows of the offset tables that the words of a motion call.
void addRowValues(const SuspectScene& scene, std::uint32_t setup, const std::vector<ResolvedOrigin>& words,
                  double depth_mm, std::vector<Suspect>& out) {
  const auto add = [&](const std::string& key, double off_mm) {
    if (auto suspect = suspectDatum(scene, setup, key, off_mm)) out.push_back(std::move(*suspect));
  };
  for (const ResolvedOrigin& word : words) {
    const auto code = codeIn(word.text);
    if (!code || code->number == 0) continue;
    if (code->letter == 'D') add(fmt::format("offsets.radius.{}", code->number), -depth_mm);
    if (code->letter == 'H') add(fmt::format("offsets.length.{}", code->number), depth_mm);
    if (code->letter != 'G' || code->number < 54 || code->number > 59) continue;
    for (const char axis : {'x', 'y', 'z'})
      add(fmt::format("offsets.work.G{}.{}", code->number, axis), depth_mm);
  }
}

/// How the part is moved and turned into a clamping.
void addTransform(const SuspectScene& scene, std::uint32_t setup, double depth_mm,
                  std::vector<Suspect>& out) {
  const SetupRun& run = scene.run.setups[setup];
  for (const char axis : {'x', 'y', 'z'}) {
    const std::string key = fmt::format("setup.{}.transform.translate.{}", run.name, axis);
    if (auto suspect = suspectDatum(scene, setup, key, -depth_mm)) out.push_back(std::move(*suspect));
  }
  const Box3 bounds = meshBounds(run.surface.mesh);
  if (bounds.empty()) return;
  const double degrees_per_mm = radToDeg(2.0 / bounds.size().maxCoeff());  // at the part's ends
  for (const char axis : {'x', 'y', 'z'}) {
    auto suspect = suspectDatum(scene, setup, fmt::format("setup.{}.transform.rotate.{}", run.name, axis),
                                -depth_mm * degrees_per_mm);
    if (!suspect) continue;
    suspect->per_mm = degrees_per_mm;
    const double quarter = 90.0 * std::round(suspect->value / 90.0);  // as most are clamped
    if (quarter != suspect->value) suspect->usual = {quarter};
    out.push_back(std::move(*suspect));
  }
}

}  // namespace

std::vector<Suspect> suspectsOf(const SuspectScene& scene, std::uint32_t setup, MotionId motion,
                                double depth_mm) {
  std::vector<Suspect> out;
  const SetupRun& run = scene.run.setups[setup];
  const Toolpath& path = run.interpreted.path;
  if (motion >= path.motions.size()) return out;
  const LineText text = lineText(path, *scene.sources[setup]);
  const SourceRef& source = path.motions[motion].source;
  const Tool* const tool = ToolTable(run.job.tools).ofMotion(path.motions[motion].tool);
  std::optional<double> fitting;
  if (path.motions[motion].wire >= 0 && scene.sources[setup]->has(path.files[source.file])) {
    fitting = addWireWords(scene, setup, source, tool, depth_mm, out);
    addZero(scene, setup, out);
    addPlanes(scene, setup, out);
  }
  if (source.origins >= 0) {
    const std::vector<ResolvedOrigin> words = originsOf(path, motion, text);
    for (const ResolvedOrigin& word : words) addWord(scene, setup, word, -depth_mm, out);
    addTransformWords(scene, setup, words, depth_mm, out);
    addRowValues(scene, setup, words, depth_mm, out);
  }
  ResolvedOrigin own;
  own.file = source.file;
  own.line = source.line;
  own.block = source.block;
  own.depth = source.depth;
  addRepeats(scene, setup, own, out);
  for (std::optional<ResolvedOrigin> call = callOf(path, motion, text); call;) {
    addRepeats(scene, setup, *call, out);
    if (call->from.empty()) break;
    const ResolvedOrigin outer = call->from.front();
    call = outer;
  }
  if (tool != nullptr) {
    for (const std::string& key : toolKeys(*tool)) {
      const bool angle = key.ends_with("_angle");
      constexpr double kAngleStep = 5.0;
      // A larger corner leaves more, a larger cutter less; a corner stands 0.4142 of its radius out of the
      // edge.
      const double step = angle ? kAngleStep : key.ends_with("corner_radius") ? -depth_mm / 0.4142 : depth_mm;
      auto suspect = suspectDatum(scene, setup, key, -step);
      if (!suspect) continue;
      if (fitting && key.ends_with(".diameter")) suspect->usual = {*fitting};
      out.push_back(std::move(*suspect));
    }
  }
  addTransform(scene, setup, depth_mm, out);
  return out;
}

}  // namespace proveout

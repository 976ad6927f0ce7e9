#include "core/nc/linuxcnc/flavours/grbl.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "core/base/characters.h"

namespace proveout::nc {
namespace {

constexpr std::size_t kGrblLongest = 79;  ///< characters of a line that count
constexpr double kGrblLastTool = 255.0, kGrblLastLine = 1e7;
constexpr int kGrblSystems = 6;

/// A modal group that a code belongs to; 0 for none.
struct GrblCode {
  int code = 0, hundredths = 0, group = 0;
};
/// Numbers of groups are free; those of M codes are above 20.
constexpr auto kGrblCodesG = std::to_array<GrblCode>({
    {0, 0, 2},   {1, 0, 2},   {2, 0, 2},   {3, 0, 2},   {4, 0, 1},   {10, 0, 1},  {17, 0, 3},  {18, 0, 3},
    {19, 0, 3},  {20, 0, 6},  {21, 0, 6},  {28, 0, 1},  {28, 10, 1}, {30, 0, 1},  {30, 10, 1}, {38, 20, 2},
    {38, 30, 2}, {38, 40, 2}, {38, 50, 2}, {40, 0, 7},  {43, 10, 8}, {49, 0, 8},  {53, 0, 1},  {54, 0, 12},
    {55, 0, 12}, {56, 0, 12}, {57, 0, 12}, {58, 0, 12}, {59, 0, 12}, {61, 0, 13}, {80, 0, 2},  {90, 0, 4},
    {91, 0, 4},  {91, 10, 5}, {92, 0, 1},  {92, 10, 1}, {93, 0, 9},  {94, 0, 9},
});
constexpr auto kGrblCodesM = std::to_array<GrblCode>({{0, 0, 21},
                                                      {1, 0, 21},
                                                      {2, 0, 21},
                                                      {30, 0, 21},
                                                      {3, 0, 22},
                                                      {4, 0, 22},
                                                      {5, 0, 22},
                                                      {6, 0, 24},
                                                      {7, 0, 23},
                                                      {8, 0, 23},
                                                      {9, 0, 23},
                                                      {56, 0, 25}});
/// Codes whose decimals GRBL calls unsupported; those of others it calls no integers.
constexpr auto kGrblDecimals = std::to_array<int>({28, 30, 38, 43, 61, 90, 91, 92});

constexpr auto kGrblMeanings = std::to_array<std::pair<int, std::string_view>>({
    {1, "a word begins with a letter: GRBL has no # parameters, brackets or other signs"},
    {2, "a letter without a number behind it: GRBL has no parameters and expressions"},
    {4, "a value below 0"},
    {11, "more than 79 characters in a line"},
    {20, "GRBL has no such code or letter"},
    {21, "two codes of one modal group"},
    {22, "no feed rate: program F"},
    {23, "a code that takes no decimals"},
    {24, "two codes that both use axis words"},
    {25, "a word stands twice in the line"},
    {26, "axis words are missing"},
    {27, "N is above 10000000"},
    {28, "P or L is missing"},
    {29, "GRBL has the work systems 1 to 6, G54 to G59"},
    {30, "G53 goes with G0 and G1 alone"},
    {31, "axis words while G80 is in force"},
    {32, "an arc without a word of an axis of its plane: a full circle names its end too"},
    {33, "the target is not possible"},
    {34, "the radius is too small to reach the end"},
    {35, "I, J, K of the plane of the arc are missing"},
    {36, "a word that no code of the line uses"},
    {37, "G43.1 takes Z alone"},
    {38, "T is above 255"},
});

/// A number from `pos` on, which goes behind it; nothing: there is none.
std::optional<double> grblNumber(std::string_view text, std::size_t& pos) {
  const std::size_t begin = pos;
  if (pos < text.size() && (text[pos] == '-' || text[pos] == '+')) ++pos;
  bool digits = false, point = false;
  for (; pos < text.size(); ++pos) {
    if (isDigit(text[pos])) {
      digits = true;
    } else if (text[pos] == '.' && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (!digits) return std::nullopt;
  return std::strtod(std::string(text.substr(begin, pos - begin)).c_str(), nullptr);
}

bool motionOf(int code) { return code <= 3 || code == 38; }
bool takesAxes(int code, int hundredths) {
  return hundredths == 0 && (code == 10 || code == 28 || code == 30 || code == 92);
}

/// Words as they come.
class GrblLine {
 public:
  explicit GrblLine(std::string_view axes) : axis_letters_(axes) {}

  /// The number of the error that the word is; 0: none.
  int take(char letter, double value) {
    const double whole = std::trunc(value);
    const auto hundredths = static_cast<int>(std::round(100.0 * (value - whole)));
    const int code = whole >= 0.0 && whole < 256.0 ? static_cast<int>(whole) : 255;
    if (letter == 'g') return takeG(code, hundredths);
    if (letter == 'm') return takeM(code, hundredths);
    const bool known = std::string_view("fijklnprstxyz").find(letter) != std::string_view::npos ||
                       axis_letters_.find(letter) != std::string_view::npos;
    if (!known) return 20;
    if (letter == 't' && value > kGrblLastTool) return 38;
    const std::uint32_t bit = 1u << (letter - 'a');
    if ((words_ & bit) != 0) return 25;
    if (value < 0.0 && std::string_view("fnpts").find(letter) != std::string_view::npos) return 4;
    words_ |= bit;
    return 0;
  }

 private:
  int takeG(int code, int hundredths) {
    const bool length = code == 43 || code == 49;
    if (takesAxes(code, hundredths) || motionOf(code) || length) {
      if (axes_) return 24;
      axes_ = true;
    }
    const auto has = [&](const GrblCode& g) { return g.code == code; };
    const auto first = std::find_if(kGrblCodesG.begin(), kGrblCodesG.end(), has);
    if (first == kGrblCodesG.end()) return 20;
    const auto found = std::find_if(first, kGrblCodesG.end(), [&](const GrblCode& g) {
      return g.code == code && (g.hundredths == hundredths || code == 49);
    });
    if (found != kGrblCodesG.end()) return group(found->group);
    const bool decimals = std::find(kGrblDecimals.begin(), kGrblDecimals.end(), code) != kGrblDecimals.end();
    return decimals ? 20 : 23;
  }
  int takeM(int code, int hundredths) {
    if (hundredths > 0) return 23;
    const auto found = std::find_if(kGrblCodesM.begin(), kGrblCodesM.end(),
                                    [&](const GrblCode& m) { return m.code == code; });
    return found == kGrblCodesM.end() ? 20 : group(found->group);
  }
  int group(int number) {
    const std::uint32_t bit = 1u << number;
    if ((groups_ & bit) != 0) return 21;
    groups_ |= bit;
    return 0;
  }

  std::string_view axis_letters_;
  std::uint32_t words_ = 0, groups_ = 0;
  bool axes_ = false;  ///< a code that uses axis words was there
};

/// The number of the error that the words of a block make together; 0: none.
class GrblBlock {
 public:
  GrblBlock(IsoContext& c, const BlockPlan& plan) : c_(c), words_(c.block.present) {
    motion_ = c.state.active[kGroupMotion];
    inverse_ = c.state.active[kGroupFeedMode] == lcn::kInverseTime;
    plane_ = c.state.active[kGroupPlane];
    if (const GCode* plane = plan.by_group[kGroupPlane]) plane_ = plane->code10;
    for (const Word& w : c.block.words)
      if (w.address == 'G') takeG(code10Of(w));
    axes_ = words_ & AddressSet("XYZ");
    command_ = moves_ || shifts_ || length_ || !axes_.empty();
    if (!axes_.empty() && !shifts_ && !length_) moves_ = true;
  }

  /// Of the codes and what they need.
  int fault() {
    if (c_.block.number > static_cast<std::int64_t>(kGrblLastLine)) return 27;
    const bool moving = moves_ && motion_ != lcn::kNoMotion && motion_ != gcode::kRapid;
    if (inverse_ && moving && !words_.has('F')) return 22;
    if (one_shot_ == lcn::kDwell && !take("P")) return 28;
    if (by_words_ && !(axes_ == AddressSet("Z"))) return 37;
    if (const int number = oneShotFault(); number != 0) return number;
    if (motion_ == lcn::kNoMotion) return axes_.empty() ? 0 : 31;
    if (moving) {
      if (!(feed() > 0.0)) return 22;
      return motionFault();
    }
    return 0;
  }
  /// Behind fault(), which marks the words that codes use.
  int unused() const {
    AddressSet used("GMNFSTE");
    if (command_) used = used | AddressSet("XYZABCUVW");
    return words_.without(used).empty() ? 0 : 36;
  }

 private:
  void takeG(int code10) {
    if (code10 == lcn::kNoMotion || code10 <= 30 || (code10 >= 382 && code10 <= 385)) {
      motion_ = code10;
      moves_ = moves_ || code10 != lcn::kNoMotion;
    }
    if (code10 == lcn::kInverseTime) inverse_ = true;
    if (code10 == gcode::kFeedPerMinute) inverse_ = false;
    length_ = length_ || code10 == lcn::kLengthByWords || code10 == gcode::kLengthOff;
    by_words_ = by_words_ || code10 == lcn::kLengthByWords;
    shifts_ = shifts_ || code10 == lcn::kData || code10 == gcode::kReference ||
              code10 == gcode::kNumberedReference || code10 == gcode::kSetPosition;
    const GCode* code = c_.codes.g(code10);
    if (code != nullptr && code->group == kOneShot) one_shot_ = code10;
  }
  const Word* word(Address letter) const { return c_.block.find(letter); }
  /// Marks words as used; false: none of them is there.
  bool take(AddressSet letters) {
    const bool any = !(words_ & letters).empty();
    words_ = words_.without(letters);
    return any;
  }

  int oneShotFault() {
    if (one_shot_ == lcn::kData) return dataFault();
    if (one_shot_ == gcode::kSetPosition && axes_.empty()) return 26;
    const bool straight = motion_ == gcode::kRapid || motion_ == gcode::kLine;
    return one_shot_ == gcode::kMachineMove && !straight ? 30 : 0;
  }
  int dataFault() {
    if (axes_.empty()) return 26;
    const Word* p = word('P');
    const Word* l = word('L');
    if (p == nullptr && l == nullptr) return 28;
    if (p != nullptr && std::trunc(p->value) > kGrblSystems) return 29;
    const double form = l == nullptr ? 0.0 : std::trunc(l->value);
    if (form != 20.0 && (form != 2.0 || words_.has('R'))) return 20;
    take("PL");
    return 0;
  }
  /// mm or 1/min; 0: there is none.
  double feed() const {
    if (const Word* f = word('F')) return f->value;
    const bool held = !inverse_ && c_.state.active[kGroupFeedMode] != lcn::kInverseTime;
    return held ? linuxCncChannel(c_).modal.feed : 0.0;
  }
  int motionFault() {
    const bool arc = motion_ == gcode::kArcClockwise || motion_ == gcode::kArcCounterClockwise;
    if (motion_ == gcode::kLine) return 0;
    if (axes_.empty()) return 26;
    if (!arc) return 0;
    AddressSet in_plane, centre;
    const int across = plane_ == gcode::kPlaneXY ? 2 : plane_ == gcode::kPlaneZX ? 1 : 0;
    for (const int axis : {(across + 1) % 3, (across + 2) % 3}) {
      in_plane.add("XYZ"[axis]);
      centre.add("IJK"[axis]);
    }
    if ((axes_ & in_plane).empty()) return 32;
    if (take("R")) return 0;
    if ((words_ & centre).empty()) return 35;
    take("IJK");
    return 0;
  }
  IsoContext& c_;
  AddressSet words_, axes_;
  std::int32_t motion_ = 0, one_shot_ = -1, plane_ = 0;
  bool inverse_ = false, moves_ = false, shifts_ = false, length_ = false, by_words_ = false,
       command_ = false;
};

/// False: there is an error, reported.
bool grblReports(IsoContext& c, int number) {
  return number == 0 ||
         c.fail(fmt::format("error-{}", number), fmt::format("error:{} {}", number, grblMeaning(number)));
}

}  // namespace

bool grblHasG(int code10) {
  return std::any_of(kGrblCodesG.begin(), kGrblCodesG.end(),
                     [&](const GrblCode& g) { return 10 * g.code + g.hundredths / 10 == code10; });
}

bool grblHasM(int code) {
  return std::any_of(kGrblCodesM.begin(), kGrblCodesM.end(),
                     [&](const GrblCode& m) { return m.code == code; });
}

std::string_view grblMeaning(int number) {
  for (const auto& [known, meaning] : kGrblMeanings)
    if (known == number) return meaning;
  return {};
}

GrblFault grblLineFault(std::string_view text, std::string_view axes) {
  if (text.size() > kGrblLongest) return {11, kGrblLongest, text.size()};
  GrblLine line(axes);
  std::size_t pos = text.starts_with('/') ? 1 : 0;
  while (pos < text.size()) {
    const std::size_t begin = pos;
    const char letter = text[pos];
    if (letter < 'a' || letter > 'z') return {1, pos, pos + 1};
    const auto value = grblNumber(text, ++pos);
    if (!value) return {2, begin, std::min(pos + 1, text.size())};
    if (letter == 'e') continue;  // told as a word of printers
    if (const int number = line.take(letter, *value); number != 0) return {number, begin, pos};
  }
  return {};
}

bool grblTakesBlock(IsoContext& c, const BlockPlan& plan) {
  return grblReports(c, GrblBlock(c, plan).fault());
}

bool grblUsesWords(IsoContext& c, const BlockPlan& plan) {
  GrblBlock block(c, plan);
  block.fault();
  return grblReports(c, block.unused());
}

}  // namespace proveout::nc

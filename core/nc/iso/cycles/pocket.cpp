#include "core/nc/iso/cycles/pocket.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/services/pocket.h"

namespace proveout::nc {
namespace {

// The macro itself, in the language of the control, so that frames, transforms and feeds apply to it as to
// any program. It moves in increments; its locals are the layout:
//   #1 #2 #3 numbers of the axes along the length, across, and of the tool    #4 levels   #5 depth of a level
//   #6 safety distance   #7 core   #8 rings   #9 feed   #10 step of the rings   #11 corner of the last ring
//   #12 code of the arcs   #15 sign of the movement across   #30 #31 codes to restore   #13 #19 #20 M S T
constexpr std::string_view kPocketText = R"(M#13 S#19 T#20
G91
#21=0
WHILE[#21LT#4]DO1
#21=#21+1
G1 AX[#3]=-[#6+#5] F[#9/2]
IF[#7EQ0] GOTO10
AX[#1]=-#7
AX[#1]=[2*#7]
N10 #22=0
WHILE[#22LT#8]DO2
#22=#22+1
#24=#22*#10
#23=#7+#24
#25=#11-[#8-#22]*#10
IF[#25LT0.000001] #25=0
#26=#24-#25
IF[#26LT0.000001] #26=0
#27=#23-#25
IF[#27LT0.000001] #27=0
G1 AX[#1]=#10 F#9
IF[#26GT0] AX[#2]=[#15*#26]
IF[#25GT0] G#12 AX[#1]=-#25 AX[#2]=[#15*#25] R#25
IF[#27GT0] G1 AX[#1]=-[2*#27]
IF[#25GT0] G#12 AX[#1]=-#25 AX[#2]=-[#15*#25] R#25
IF[#26GT0] G1 AX[#2]=-[2*#15*#26]
IF[#25GT0] G#12 AX[#1]=#25 AX[#2]=-[#15*#25] R#25
IF[#27GT0] G1 AX[#1]=[2*#27]
IF[#25GT0] G#12 AX[#1]=#25 AX[#2]=[#15*#25] R#25
IF[#26GT0] G1 AX[#2]=[#15*#26]
END2
#28=#6
IF[#21EQ#4] #28=#6+#4*#5
G0 AX[#3]=#28
IF[[#7+#8*#10]GT0] AX[#1]=-[#7+#8*#10]
END1
G#30 G#31 F#9
M99
)";

/// Variables of the call's arguments.
enum Argument {
  kI = 4,
  kJ,
  kK,
  kD = 7,
  kE = 8,
  kF = 9,
  kM = 13,
  kQ = 17,
  kR = 18,
  kS = 19,
  kT = 20,
  kX = 24
};

/// Letters that the macro does not know, by variable.
constexpr std::string_view kUnknownLetters = "ABCHNOUVW";
constexpr std::array<std::size_t, 9> kUnknownVariables{1, 2, 3, 11, 14, 15, 21, 22, 23};

std::optional<double> given(const Arguments& args, std::size_t variable) {
  const Value& value = args.v[variable];
  return value.vacant ? std::nullopt : std::optional(value.number);
}

/// The radius of the register that D names, in the units of the program; none: D is missing.
bool toolRadius(IsoContext& c, const Arguments& args, std::optional<double>& radius) {
  const auto row = given(args, kD);
  if (!row) return true;
  const double whole = std::round(*row);
  if (!(whole >= 0.0 && whole <= c.parameters[CompParam::kToolOffsets]))
    return c.alarm(SharedAlarm::kOutOfRange, "D");
  radius =
      c.registers.offsets.effective(OffsetColumn::kRadius, static_cast<int>(whole)) / c.state.unitScale();
  return true;
}

bool checkCall(IsoContext& c, const Arguments& args) {
  for (std::size_t k = 0; k < kUnknownVariables.size(); ++k) {
    if (!args.v[kUnknownVariables[k]].vacant)
      return c.alarm(SharedAlarm::kIllegalAddress, kUnknownLetters.substr(k, 1),
                     "the pocket macro has no such argument");
  }
  if (c.state.compOn()) return c.fail("pocket-in-comp", "the pocket macro runs in G40");
  return true;
}

/// The locals are laid out by all arguments together.
std::uint32_t originOfCall(IsoContext& c, const Arguments& args) {
  std::vector<std::uint32_t> origins;
  for (const Value& value : args.v) {
    if (!value.vacant && value.origin != 0) origins.push_back(value.origin);
  }
  const Word* call = c.block.find('G');
  return c.origins.numberOf(OriginKind::kArgument, call->columns, call->value, c.origins.listOf(origins));
}

}  // namespace

bool pocketFrame(IsoContext& c, CallFrame& frame) {
  const Arguments& in = frame.args;
  if (!checkCall(c, in)) return false;
  const PlaneFrame plane(c.state.plane());
  const auto size = [&](int axis) { return given(in, static_cast<std::size_t>(kX + axis)); };
  PocketRequest request;
  request.first = size(plane.u());
  request.second = size(plane.v());
  request.depth = size(plane.w());
  request.corner = given(in, kR);
  request.cut = given(in, kQ);
  request.width_percent = given(in, kE).value_or(request.width_percent);
  if (!toolRadius(c, in, request.tool_radius)) return false;
  const PocketLayout layout = layOutPocket(request);
  if (layout.error != PocketError::kNone) {
    const int number = layout.error == PocketError::kMissing ? 1 : 2;
    return c.fail(fmt::format("macro-error-{}", number),
                  fmt::format("MACRO ERROR {}: {}", number, layout.reason));
  }
  const double feed = given(in, kF).value_or(c.state.feed);
  if (!(feed > 0.0)) return c.fail("feed", "no feed is programmed: the pocket macro needs F");
  const auto safety = given(in, static_cast<std::size_t>(kI + plane.w()));
  if (!safety) {
    c.warn("pocket-safety",
           fmt::format("no safety distance {}: the tool is taken to stand on the surface", "IJK"[plane.w()]));
  }
  Arguments out;
  const std::uint32_t origin = originOfCall(c, in);
  const auto set = [&](std::size_t variable, double value) { out.v[variable] = {value, false, origin}; };
  const int along = layout.length_is_first ? plane.u() : plane.v();
  const int across = layout.length_is_first ? plane.v() : plane.u();
  set(1, c.axes.at(along).number);
  set(2, c.axes.at(across).number);
  set(3, c.axes.at(plane.w()).number);
  set(4, static_cast<double>(layout.levels));
  set(5, layout.level_step);
  set(6, std::abs(safety.value_or(0.0)));
  set(7, layout.core);
  set(8, static_cast<double>(layout.rings));
  set(9, feed);
  set(10, layout.ring_step);
  set(11, layout.outer_corner);
  set(12, layout.clockwise ? 2 : 3);
  set(15, layout.length_is_first != layout.clockwise ? 1 : -1);
  set(30, c.state.active[kGroupDistance] / 10.0);
  set(31, c.state.active[kGroupMotion] / 10.0);
  for (const std::size_t function : {kM, kS, kT}) out.v[function] = in.v[function];
  frame.args = out;
  const ProgramStore::Loaded loaded = c.programs.builtIn("O9999 (built in)", kPocketText);
  frame.setProgram(*loaded.text, loaded.file);
  return true;
}

}  // namespace proveout::nc

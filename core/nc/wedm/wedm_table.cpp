// The tables of codes.
#include <algorithm>
#include <array>

#include "core/nc/wedm/wedm_codes.h"

namespace proveout::nc {

namespace {

using WG = WedmGroup;
using WS = WedmState;

void setMirrorX(WS& s) { s.mirror_x = 1; }
void setMirrorY(WS& s) { s.mirror_y = 1; }
void setSwap(WS& s) { s.swap = 1; }
void endMirror(WS& s) { s.mirror_x = s.mirror_y = s.swap = 0; }
void endExtension(WS& s) { s.extension = 0.0; }
void endOvercut(WS& s) {
  s.overcut = s.overcut_dwell = 0.0;
  s.overcut_on = 0;
}

// clang-format off: one row a line
constexpr auto kWedmG = std::to_array<WedmGCode>({
    {0, WG::kMotion, &WS::motion, nullptr, "SIM", "wedm-5.1-G00 wedm-2.2-axes",
     "rapid, straight, all axes together"},
    {1, WG::kMotion, &WS::motion, nullptr, "SIM", "wedm-5.2-G01", "line"},
    {2, WG::kMotion, &WS::motion, nullptr, "SIM", "wedm-5.3-G02 wedm-5.3-IJ", "arc, clockwise"},
    {3, WG::kMotion, &WS::motion, nullptr, "SIM", "wedm-5.3-G03", "arc, counter-clockwise"},
    {4, WG::kOneShot, nullptr, nullptr, "TIME", "wedm-5-G04", "dwell X seconds"},
    {5, WG::kMirror, nullptr, setMirrorX, "SIM", "wedm-5.4-G05", "mirror: X goes the other way"},
    {6, WG::kMirror, nullptr, setMirrorY, "SIM", "wedm-5.4-G06", "mirror: Y goes the other way"},
    {8, WG::kMirror, nullptr, setSwap, "SIM", "wedm-5.4-G08", "X and Y change places"},
    {9, WG::kMirror, nullptr, endMirror, "SIM", "wedm-5.4-G09", "no mirror, no change of places"},
    {11, WG::kSkip, &WS::skip, nullptr, "SIM", "wedm-5.5-G11 wedm-4-skip", "blocks with / are skipped"},
    {12, WG::kSkip, &WS::skip, nullptr, "SIM", "wedm-5.5-G12", "blocks with / are executed"},
    {20, WG::kUnits, &WS::units, nullptr, "SIM", "wedm-5.5.1-G20", "inch"},
    {21, WG::kUnits, &WS::units, nullptr, "SIM", "wedm-5.5.1-G21 wedm-1.4-units", "mm"},
    {28, WG::kCorner, &WS::corner, nullptr, "SIM", "wedm-5.5.2-G28", "arcs at outer corners"},
    {29, WG::kCorner, &WS::corner, nullptr, "SIM", "wedm-5.5.2-G29", "straight outer corners"},
    {30, WG::kExtension, nullptr, endExtension, "SIM", "wedm-5.5.3-G30", "no extension"},
    {31, WG::kExtension, nullptr, nullptr, "SIM", "wedm-5.5.3-G31",
     "lines go on past their end by X and back"},
    {34, WG::kSlow, &WS::slow, nullptr, "TIME", "wedm-5.5.4-G34", "slower in the last 3 mm of a block"},
    {35, WG::kSlow, &WS::slow, nullptr, "TIME", "wedm-5.5.4-G35", "full speed to the end of a block"},
    {36, WG::kOvercut, nullptr, endOvercut, "SIM", "wedm-5.5.5-G36", "no corner overcut"},
    {37, WG::kOvercut, nullptr, nullptr, "SIM", "wedm-5.5.5-G37", "corner overcut X"},
    {40, WG::kOffset, &WS::offset, nullptr, "SIM", "wedm-5.6-G40 wedm-5.6.4-cancel", "offset off"},
    {41, WG::kOffset, &WS::offset, nullptr, "SIM", "wedm-5.6-G41", "offset, wire left of the contour"},
    {42, WG::kOffset, &WS::offset, nullptr, "SIM", "wedm-5.6-G42", "offset, wire right of the contour"},
    {50, WG::kTaper, &WS::taper, nullptr, "SIM", "wedm-5.7-G50", "taper off"},
    {51, WG::kTaper, &WS::taper, nullptr, "SIM", "wedm-5.7-G51", "the wire leans left"},
    {52, WG::kTaper, &WS::taper, nullptr, "SIM", "wedm-5.7-G52", "the wire leans right"},
    {54, WG::kSystem, &WS::system, nullptr, "SIM", "wedm-5.8-G54", "work system 0"},
    {55, WG::kSystem, &WS::system, nullptr, "SIM", "wedm-5.8-G55", "work system 1"},
    {56, WG::kSystem, &WS::system, nullptr, "SIM", "wedm-5.8-G56", "work system 2"},
    {57, WG::kSystem, &WS::system, nullptr, "SIM", "wedm-5.8-G57", "work system 3"},
    {58, WG::kSystem, &WS::system, nullptr, "SIM", "wedm-5.8-G58", "work system 4"},
    {59, WG::kSystem, &WS::system, nullptr, "SIM", "wedm-5.8-G59", "work system 5"},
    {60, WG::kShape, &WS::shape, nullptr, "SIM", "wedm-5.9-G60", "one shape for top and bottom"},
    {61, WG::kShape, &WS::shape, nullptr, "SIM", "wedm-5.9-G61 wedm-5.9-colon",
     "different shapes, lower : upper"},
    {74, WG::kFourAxis, &WS::four_axis, nullptr, "SIM", "wedm-5.9.1-G74", "four axes: U V from X Y"},
    {75, WG::kFourAxis, &WS::four_axis, nullptr, "SIM", "wedm-5.9.1-G75", "four axes off"},
    {90, WG::kDistance, &WS::distance, nullptr, "SIM", "wedm-5.10-G90 wedm-1.5-abs-inc", "absolute"},
    {91, WG::kDistance, &WS::distance, nullptr, "SIM", "wedm-5.10-G91", "incremental"},
    {92, WG::kOneShot, nullptr, nullptr, "SIM", "wedm-5.11-G92 wedm-5.6.6-G92",
     "names the point in the work system"},
});

constexpr auto kWedmFunctions = std::to_array<WedmFunction>({
    {'M', 0, &WS::by_hand, 1, "STATE", "wedm-8.1-M00", "stop"},
    {'M', 2, nullptr, 0, "STATE", "wedm-8.2-M02", "end and reset"},
    {'M', 50, &WS::threaded, 0, "SIM", "wedm-8.5-M50", "cut the wire"},
    {'M', 60, &WS::threaded, 1, "SIM", "wedm-8.6-M60", "thread the wire"},
    {'M', 98, nullptr, 0, "SIM", "wedm-8.3-M98 wedm-10-P wedm-10-L", "call of subprogram P, L times"},
    {'M', 99, nullptr, 0, "SIM", "wedm-8.4-M99", "end of a subprogram"},
    {'T', 84, &WS::fluid, 1, "STATE", "wedm-15-T84", "fluid on"},
    {'T', 85, &WS::fluid, 0, "STATE", "wedm-15-T85", "fluid off"},
    {'T', 86, &WS::wire_runs, 1, "STATE", "wedm-15-T86", "wire runs"},
    {'T', 87, &WS::wire_runs, 0, "STATE", "wedm-15-T87", "wire stands"},
});

constexpr auto kWedmFeatures = std::to_array<WedmFeature>({
    {"N", "STATE", "wedm-3-N", "number of a block, label of a subprogram"},
    {"A", "SIM", "wedm-5.7-A wedm-7.5-variable", "taper angle, degrees"},
    {"C", "TIME", "wedm-9-C", "cutting condition"},
    {"H", "SIM", "wedm-5.6.1-H wedm-12-H", "offsets and variables"},
    {"R", "SIM", "wedm-14-R wedm-7.4-RR", "rounded corners, of both planes"},
    {"U V", "SIM", "wedm-6-UV", "upper guide"},
    {"X Y", "SIM", "wedm-6-XY", "table"},
    {"Z", "REJECT", "wedm-1.2-Z", "no motion along Z"},
    {"expressions", "SIM", "wedm-11-expr", "numbers and H with + and -"},
});
// clang-format on

}  // namespace

std::span<const WedmGCode> wedmGCodes() { return kWedmG; }
std::span<const WedmFunction> wedmFunctions() { return kWedmFunctions; }
std::span<const WedmFeature> wedmFeatures() { return kWedmFeatures; }

const WedmGCode* wedmGCode(int code) {
  const auto found =
      std::find_if(kWedmG.begin(), kWedmG.end(), [&](const WedmGCode& g) { return g.code == code; });
  return found == kWedmG.end() ? nullptr : &*found;
}

const WedmFunction* wedmFunction(char address, int code) {
  const auto found = std::find_if(kWedmFunctions.begin(), kWedmFunctions.end(), [&](const WedmFunction& f) {
    return f.address == address && f.code == code;
  });
  return found == kWedmFunctions.end() ? nullptr : &*found;
}

}  // namespace proveout::nc

#include "core/nc/iso/parameters/axis.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(AxisParam::kCount)> kAxisRows{{
    atPowerOn(number("N0100", 100, kAxis, 0, 0, 90,
                     "first character of the axis' name, as its ASCII code; 0: as the job says")),
    atPowerOn(number("N0101", 101, kAxis, 0, 0, 90, "second character of the name; 0: none")),
    atPowerOn(number("N0102", 102, kAxis, 0, 0, 90, "third character of the name; 0: none")),
    atPowerOn(number("N0103", 103, kAxis, 0, 0, 3,
                     "axis of the planes: 1 X, 2 Y, 3 Z or parallel to it; 0: as the job says")),
    atPowerOn(bit("N0104.IND", 104, kNamedBit, kGlobal, 0, "encoders count inches; no effect on paths")),
    number("N0105", 105, kGlobal, 2, 1, 5, "decimals of the display: 1 ISA to 5 ISE; no effect on paths"),
    bit("N0106.DIA", 106, 0, kAxis, 0, "words of the axis are diameters"),
    atPowerOn(bit("N0106.ROT", 106, 1, kAxis, 0, "rotary axis; 0: as the job says")),
    bit("N0106.MGD", 106, 5, kAxis, 1, "G10.9 may switch between radius and diameter"),
    bit("N0107.REN", 107, 0, kAxis, 0, "rotary axis counts within one turn"),
    bit("N0107.ASH", 107, 1, kAxis, 0, "absolute words go the shorter way round"),
    bit("N0107.ABS", 107, 2, kAxis, 0, "the sign of an absolute word is the direction"),
    number("N0108", 108, kAxis, 360, 1e-3, 1e6, "travel of one turn, deg"),
    number("N0217", 217, kAxis, 0, -1e3, 1e3,
           "distance of the tool from the plane of the linear and the rotary axis, mm; told, not simulated"),
    noted(number(
        "N0200", 200, kAxis, 0, -1e6, 1e6,
        "reference position 1, that levels the second drive of a gantry, mm; drives are level here, and "
        "G28 goes to reference_points of the machine")),
    number("N3100", 3100, kChannel, 0, 0, 1e6, "smoothing: longer blocks stay straight, mm; 0: all"),
    number("N3101", 3101, kChannel, 0, 0, 1e6, "smoothing: shorter blocks stay straight, mm"),
    number("N3102", 3102, kChannel, 0, 0, 180, "smoothing: sharper corners stay, deg; 0: all"),
    number("N3103", 3103, kChannel, 0, 0, 1e3, "smoothing: shorter steps are joined to one, mm"),
    number("N3104", 3104, kChannel, 0, 0, 1e3, "smoothing Q2: largest deviation from the chord, mm"),
    number("N3105", 3105, kChannel, 0, 0, 1e3, "smoothing Q2: smaller deviations stay straight, mm"),
    number("N3106", 3106, kChannel, 0, 0, 1e3, "smoothing Q3: largest deviation of the path, mm"),
    number("N3107", 3107, kChannel, 0, 0, 1e3, "smoothing Q3: shorter blocks are smoothed at any angle, mm"),
}};

}  // namespace

std::span<const ParamInfo> axisParams() { return kAxisRows; }

}  // namespace proveout::nc

// Spindle.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kSpindleGCodes = std::to_array<GCode>({
    modal(960, kGroupSurfaceSpeed, kTime, "nct-3-G96 nct-11.5.1-G96 nct-11.5.3-G96P",
          "constant surface speed", "P"),
    modal(970, kGroupSurfaceSpeed, kTime, "nct-3-G97 nct-11.5.1-G97", "constant surface speed off"),
});

constexpr auto kSpindleMCodes = std::to_array<MCode>({
    {3, MPhase::kBefore, kSpindleCodes, kState, {}, "nct-11.2-M3", "spindle clockwise"},
    {4, MPhase::kBefore, kSpindleCodes, kState, {}, "nct-11.2-M4", "spindle counter-clockwise"},
    {5, MPhase::kAfter, kSpindleCodes, kState, {}, "nct-11.2-M5", "spindle stop"},
    {11, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 1"},
    {12, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 2"},
    {13, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 3"},
    {14, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 4"},
    {15, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 5"},
    {16, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 6"},
    {17, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 7"},
    {18, MPhase::kBefore, kGearCodes, kState, {}, "nct-11.3-M11-M18", "spindle range 8"},
    {19, MPhase::kAfter, kSpindleCodes, kState, {}, "nct-11.7.1-M19", "spindle orientation"},
});

constexpr auto kSpindleFeatures = std::to_array<FeatureRow>({
    {"S", kState, "nct-1.1-S nct-11.1-S nct-11.1.1-SP nct-11.1.1-Sname nct-11.1.2-channel", "spindle speed"},
    {"G92 S", kTime, "nct-11.5.2-G92S", "speed limit of G96"},
    {"main spindle", kState, "nct-11.4-main", "M codes of the machine's configuration"},
    {"spindle M", kHost, "nct-11.2-Mopt nct-11.6-monitor", "further spindle codes, monitoring"},
    {"position loop", kState, "nct-11.7.2-M24 nct-11.7.3-pos nct-11.7.3-index nct-11.7.5-off",
     "a spindle turns to an angle, by words and M codes"},
    {"spindles together", kState, "nct-11.7.4-sync nct-11.8-convert",
     "a spindle follows another one or becomes an axis"},
});

}  // namespace

CodeTable spindleTable() { return {kSpindleGCodes, kSpindleMCodes, kSpindleFeatures}; }

}  // namespace proveout::nc

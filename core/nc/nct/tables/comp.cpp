// Length and cutter compensation.
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kCompGCodes = std::to_array<GCode>({
    modal(380, kOneShot, kSim, "nct-3-G38 nct-15.5.5-G38", "keep the compensation vector"),
    action(390, kOneShot, kSim, "IJK", planCornerArc, false, "nct-3-G39 nct-15.5.6-G39", "corner arc"),
    modal(400, kGroupRadiusComp, kSim,
          "nct-3-G40 nct-15.5-G40 nct-15.5.3-G40 nct-15.5.3-IJK nct-15.5.3-noaxis", "cutter compensation off",
          "IJK"),
    modal(410, kGroupRadiusComp, kSim,
          "nct-3-G41 nct-15.5-G41 nct-15.5.1-G41 nct-15.5.1-noaxis nct-15.5.1-IJK nct-15.5.2-inner "
          "nct-15.5.2-obtuse "
          "nct-15.5.2-acute",
          "cutter compensation left", "IJK"),
    modal(420, kGroupRadiusComp, kSim, "nct-3-G42 nct-15.5-G42 nct-15.5.4-change",
          "cutter compensation right", "IJK"),
    modal(430, kGroupLengthComp, kSim, "nct-3-G43 nct-15.3-G43 nct-15.3-INC", "length compensation +", {},
          true),
    modal(437, kGroupLengthComp, kSim, "nct-3-G43.7 nct-15.4-G43.7 nct-15.4-G49 nct-15.4-back nct-15.4-N1414",
          "turning offsets"),
    modal(440, kGroupLengthComp, kSim, "nct-3-G44 nct-15.3-G44", "length compensation -", {}, true),
    modal(490, kGroupLengthComp, kSim, "nct-3-G49 nct-15.3-G49", "length compensation off", {}, true),
});

constexpr auto kCompFeatures = std::to_array<FeatureRow>({
    {"H", kSim, "nct-1.1-HD nct-15.1-H nct-15.1-cornerradius nct-15.1-row0 nct-15.3-H-modal",
     "length offset row, read when programmed"},
    {"D", kSim, "nct-15.1-D nct-15.5-D0 nct-15.5-negR nct-15.5.2-newD",
     "radius offset row, read when programmed"},
    {"length axes", kSim, "nct-15.3-ZAX nct-15.3-PLN nct-15.3-AXES nct-15.3-N1300",
     "axes of length compensation"},
    {"comp corners", kSim,
     "nct-15.5-alpha nct-15.5-parplane nct-15.5.2-zero nct-15.5.2-spiral nct-15.5.2-N1405 "
     "nct-15.5.1-zeromove "
     "nct-15.5.1-nextzero",
     "corner classes of cutter compensation"},
    {"comp functions", kSim, "nct-15.5.2-passthrough nct-15.5.2-flush nct-15.5.2-skip",
     "functions, flushing codes and skip blocks inside cutter compensation"},
    {"comp side", kSim, "nct-15.5.4-LL nct-15.5.4-LA nct-15.5.4-AX nct-15.5.4-full nct-15.5.4-err",
     "change of side"},
    {"comp check", kSim, "nct-15.5.7-IEN nct-15.5.7-AAL nct-15.5.7-N1404", "interference check"},
    {"comp limits", kReject, "nct-15.5-plane nct-15.5.1-arc", "plane change and start in an arc are errors"},
    {"2043", kReject, "nct-15.5.3-2043", "G40 in circular interpolation"},
    {"2047", kReject, "nct-15.5.2-2047", "no intersection in cutter compensation"},
    {"2049", kReject, "nct-15.5.7-2049", "interference in cutter compensation"},
    {"2090", kReject, "nct-15.5.2-2090", "cutter compensation: buffer full"},
});

}  // namespace

CodeTable compTable() { return {kCompGCodes, {}, kCompFeatures}; }

}  // namespace proveout::nc

#include "core/nc/nct/parameters/program.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

/// The manual names these without a number: programs cannot reach them.
constexpr int kNoNumber = -1;

constexpr std::array<ParamInfo, static_cast<std::size_t>(ProgramParam::kCount)> kProgramRows{{
    atPowerOn(
        number("N2201", 2201, kGlobal, 0, 0, 99999999, "first waiting code of channels; 0: there are none")),
    atPowerOn(
        number("N2202", 2202, kGlobal, 0, 0, 99999999, "last waiting code of channels; at most 100 codes")),
    bit("N1301.CLR", 1301, kNamedBit, kChannel, 0,
        "reset and program end: 1 groups whose CLR bit is set keep their code, 0 none does"),
    bit("CLR.C01", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 1 keeps its code at reset"),
    bit("CLR.C02", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 2 keeps its code at reset"),
    bit("CLR.C03", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 3 keeps its code at reset"),
    bit("CLR.C04", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 4 keeps its code at reset"),
    bit("CLR.C05", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 5 keeps its code at reset"),
    bit("CLR.C06", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 6 keeps its code at reset"),
    bit("CLR.C07", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 7 keeps its code at reset"),
    bit("CLR.C08", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 8 keeps its code at reset"),
    bit("CLR.C09", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 9 keeps its code at reset"),
    bit("CLR.C10", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 10 keeps its code at reset"),
    bit("CLR.C11", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 11 keeps its code at reset"),
    bit("CLR.C12", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 12 keeps its code at reset"),
    bit("CLR.C13", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 13 keeps its code at reset"),
    bit("CLR.C14", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 14 keeps its code at reset"),
    bit("CLR.C15", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 15 keeps its code at reset"),
    bit("CLR.C16", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 16 keeps its code at reset"),
    bit("CLR.C17", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 17 keeps its code at reset"),
    bit("CLR.C18", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 18 keeps its code at reset"),
    bit("CLR.C19", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 19 keeps its code at reset"),
    bit("CLR.C20", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 20 keeps its code at reset"),
    bit("CLR.C21", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 21 keeps its code at reset"),
    bit("CLR.C22", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 22 keeps its code at reset"),
    bit("CLR.C23", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 23 keeps its code at reset"),
    bit("CLR.C24", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 24 keeps its code at reset"),
    bit("CLR.C25", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 25 keeps its code at reset"),
    bit("CLR.C26", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 26 keeps its code at reset"),
    bit("CLR.C27", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 27 keeps its code at reset"),
    bit("CLR.C28", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 28 keeps its code at reset"),
    bit("CLR.C29", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 29 keeps its code at reset"),
    bit("CLR.C30", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 30 keeps its code at reset"),
    bit("CLR.C31", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 31 keeps its code at reset"),
    bit("CLR.C32", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 32 keeps its code at reset"),
    bit("CLR.C33", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 33 keeps its code at reset"),
    bit("CLR.C34", kNoNumber, kNamedBit, kChannel, 0, "CLR G tables: G group 34 keeps its code at reset"),
    number("BUF.M1", kNoNumber, kChannel, 0, 0, 99999999, "M code 1 that ends look-ahead; 0: none"),
    number("BUF.M2", kNoNumber, kChannel, 0, 0, 99999999, "M code 2 that ends look-ahead; 0: none"),
    number("BUF.M3", kNoNumber, kChannel, 0, 0, 99999999, "M code 3 that ends look-ahead; 0: none"),
    number("BUF.M4", kNoNumber, kChannel, 0, 0, 99999999, "M code 4 that ends look-ahead; 0: none"),
    number("BUF.M5", kNoNumber, kChannel, 0, 0, 99999999, "M code 5 that ends look-ahead; 0: none"),
    number("BUF.M6", kNoNumber, kChannel, 0, 0, 99999999, "M code 6 that ends look-ahead; 0: none"),
    number("BUF.M7", kNoNumber, kChannel, 0, 0, 99999999, "M code 7 that ends look-ahead; 0: none"),
    number("BUF.M8", kNoNumber, kChannel, 0, 0, 99999999, "M code 8 that ends look-ahead; 0: none"),
    number("BUF.M9", kNoNumber, kChannel, 0, 0, 99999999, "M code 9 that ends look-ahead; 0: none"),
    number("BUF.M10", kNoNumber, kChannel, 0, 0, 99999999, "M code 10 that ends look-ahead; 0: none"),
    number("BUF.LOW1", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 1 that ends look-ahead; 0: none"),
    number("BUF.LOW2", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 2 that ends look-ahead; 0: none"),
    number("BUF.LOW3", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 3 that ends look-ahead; 0: none"),
    number("BUF.LOW4", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 4 that ends look-ahead; 0: none"),
    number("BUF.LOW5", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 5 that ends look-ahead; 0: none"),
    number("BUF.LOW6", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 6 that ends look-ahead; 0: none"),
    number("BUF.LOW7", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 7 that ends look-ahead; 0: none"),
    number("BUF.LOW8", kNoNumber, kChannel, 0, 0, 99999999,
           "lowest M code of range 8 that ends look-ahead; 0: none"),
    number("BUF.HIGH1", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 1 that ends look-ahead"),
    number("BUF.HIGH2", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 2 that ends look-ahead"),
    number("BUF.HIGH3", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 3 that ends look-ahead"),
    number("BUF.HIGH4", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 4 that ends look-ahead"),
    number("BUF.HIGH5", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 5 that ends look-ahead"),
    number("BUF.HIGH6", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 6 that ends look-ahead"),
    number("BUF.HIGH7", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 7 that ends look-ahead"),
    number("BUF.HIGH8", kNoNumber, kChannel, 0, 0, 99999999,
           "highest M code of range 8 that ends look-ahead"),
    bit("BUF.A1", kNoNumber, kNamedBit, kChannel, 0, "auxiliary function 1 (N1333) ends look-ahead"),
    bit("BUF.A2", kNoNumber, kNamedBit, kChannel, 0, "auxiliary function 2 (N1334) ends look-ahead"),
    bit("BUF.A3", kNoNumber, kNamedBit, kChannel, 0, "auxiliary function 3 (N1335) ends look-ahead"),
    bit("BUF.S", kNoNumber, kNamedBit, kChannel, 0, "S ends look-ahead"),
    bit("BUF.T", kNoNumber, kNamedBit, kChannel, 0, "T ends look-ahead"),
}};

}  // namespace

std::span<const ParamInfo> programParams() { return kProgramRows; }

}  // namespace proveout::nc

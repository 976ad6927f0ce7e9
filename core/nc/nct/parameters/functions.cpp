#include "core/nc/iso/parameters/functions.h"

#include "core/nc/nct/parameters/rows.h"

namespace proveout::nc {
namespace {

using namespace param_rows;

constexpr std::array<ParamInfo, static_cast<std::size_t>(FunctionParam::kCount)> kFunctionsRows{{
    number("N1333", 1333, kChannel, 0, 0, 90,
           "address of auxiliary function 1 as its character code (65 A, 66 B, 67 C, 85 U, 86 V, 87 W); 0: "
           "none"),
    number("N1334", 1334, kChannel, 0, 0, 90,
           "address of auxiliary function 2 as its character code (65 A, 66 B, 67 C, 85 U, 86 V, 87 W); 0: "
           "none"),
    number("N1335", 1335, kChannel, 0, 0, 90,
           "address of auxiliary function 3 as its character code (65 A, 66 B, 67 C, 85 U, 86 V, 87 W); 0: "
           "none"),
    number("N1341", 1341, kChannel, 0, 0, 99999999, "lowest M code of group 1; 0: no group"),
    number("N1342", 1342, kChannel, 0, 0, 99999999, "lowest M code of group 2; 0: no group"),
    number("N1343", 1343, kChannel, 0, 0, 99999999, "lowest M code of group 3; 0: no group"),
    number("N1344", 1344, kChannel, 0, 0, 99999999, "lowest M code of group 4; 0: no group"),
    number("N1345", 1345, kChannel, 0, 0, 99999999, "lowest M code of group 5; 0: no group"),
    number("N1346", 1346, kChannel, 0, 0, 99999999, "lowest M code of group 6; 0: no group"),
    number("N1347", 1347, kChannel, 0, 0, 99999999, "lowest M code of group 7; 0: no group"),
    number("N1348", 1348, kChannel, 0, 0, 99999999, "lowest M code of group 8; 0: no group"),
    number("N1349", 1349, kChannel, 0, 0, 99999999, "lowest M code of group 9; 0: no group"),
    number("N1350", 1350, kChannel, 0, 0, 99999999, "lowest M code of group 10; 0: no group"),
    number("N1351", 1351, kChannel, 0, 0, 99999999, "lowest M code of group 11; 0: no group"),
    number("N1352", 1352, kChannel, 0, 0, 99999999, "lowest M code of group 12; 0: no group"),
    number("N1353", 1353, kChannel, 0, 0, 99999999, "lowest M code of group 13; 0: no group"),
    number("N1354", 1354, kChannel, 0, 0, 99999999, "lowest M code of group 14; 0: no group"),
    number("N1355", 1355, kChannel, 0, 0, 99999999, "lowest M code of group 15; 0: no group"),
    number("N1356", 1356, kChannel, 0, 0, 99999999, "lowest M code of group 16; 0: no group"),
    number("N1357", 1357, kChannel, 0, 0, 99999999, "highest M code of group 1"),
    number("N1358", 1358, kChannel, 0, 0, 99999999, "highest M code of group 2"),
    number("N1359", 1359, kChannel, 0, 0, 99999999, "highest M code of group 3"),
    number("N1360", 1360, kChannel, 0, 0, 99999999, "highest M code of group 4"),
    number("N1361", 1361, kChannel, 0, 0, 99999999, "highest M code of group 5"),
    number("N1362", 1362, kChannel, 0, 0, 99999999, "highest M code of group 6"),
    number("N1363", 1363, kChannel, 0, 0, 99999999, "highest M code of group 7"),
    number("N1364", 1364, kChannel, 0, 0, 99999999, "highest M code of group 8"),
    number("N1365", 1365, kChannel, 0, 0, 99999999, "highest M code of group 9"),
    number("N1366", 1366, kChannel, 0, 0, 99999999, "highest M code of group 10"),
    number("N1367", 1367, kChannel, 0, 0, 99999999, "highest M code of group 11"),
    number("N1368", 1368, kChannel, 0, 0, 99999999, "highest M code of group 12"),
    number("N1369", 1369, kChannel, 0, 0, 99999999, "highest M code of group 13"),
    number("N1370", 1370, kChannel, 0, 0, 99999999, "highest M code of group 14"),
    number("N1371", 1371, kChannel, 0, 0, 99999999, "highest M code of group 15"),
    number("N1372", 1372, kChannel, 0, 0, 99999999, "highest M code of group 16"),
}};

}  // namespace

std::span<const ParamInfo> functionParams() { return kFunctionsRows; }

}  // namespace proveout::nc

// Text, words and settings: what is neither a G nor an M code.
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/iso/model/code_rows.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kFanucTextTableFeatures = std::to_array<FeatureRow>({
    {"power_on_*", kState, "fan-1-poweron", "modal codes at the start of each program"},
    {"M30/reset", kState, "fan-1-reset", "what the end of a program clears and what stays"},
    {"settings", kState, "fan-1-settingnote", "one note a setting that the path depends on"},
    {"%", kSim, "fan-2-pct", "tape start and end"},
    {"leader", kHost, "fan-2-leader", "text before the first % is left out"},
    {"O", kSim, "fan-2-o", "program number, several in a file"},
    {":", kSim, "fan-2-colon", "program number"},
    {"<NAME>", kSim, "fan-2-name", "program name"},
    {"N", kState, "fan-2-n", "sequence number"},
    {";", kSim, "fan-2-eob", "end of block; behind it the next block or a comment"},
    {"( )", kHost, "fan-2-comment", "comment; nested and open ones are noted"},
    {"/", kSim, "fan-2-skip", "optional block skip 1 to 9"},
    {"words", kSim, "fan-2-words fan-2-null fan-2-round fan-2-decimal",
     "letter with number, variable or formula; without a point by `decimal`"},
    {"order", kSim, "fan-2-order", "order of execution in a block"},
    {"groups", kState, "fan-2-modal", "the last code of a group holds"},
    {"M words", kHost, "fan-2-mcount fan-2-unknownm",
     "several M functions, and those of the machine builder"},
    {"5074", kReject, "fan-2-twice", "an address twice in a block"},
    {"003-009", kReject, "fan-2-range", "numbers and addresses that are none"},
    {"010", kReject, "fan-2-unknown", "G codes that the control does not have"},
    {",C ,R ,A", kSim, "fan-2-comma", "words behind a comma"},
});

}  // namespace

CodeTable fanucTextTable() { return {{}, {}, kFanucTextTableFeatures}; }

}  // namespace proveout::nc

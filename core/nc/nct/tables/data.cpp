// System variables, parameters, output of programs.
#include "core/nc/iso/model/code_rows.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

using namespace rows;

constexpr auto kDataFeatures = std::to_array<FeatureRow>({
    {"#_NAME", kState, "nct-23.1.5-notation", "system variables by number and by name"},
    {"#1000", kState, "nct-23.1.7-in", "inputs of the PLC"},
    {"#1100", kState, "nct-23.1.7-out", "outputs of the PLC"},
    {"#3000", kState, "nct-23.1.8-3000", "alarm of the program"},
    {"#3001", kTime, "nct-23.1.9-3001 nct-23.1.9-3002", "clocks"},
    {"#3003", kHost, "nct-23.1.10-3003", "single block suppressed"},
    {"#3004", kTime, "nct-23.1.10-3004", "STOP, override and exact stop suppressed"},
    {"#3006", kState, "nct-23.1.8-3006", "stop with a message"},
    {"#3007", kState, "nct-23.1.12-3007", "mirrored axes"},
    {"#3011", kHost, "nct-23.1.9-3011", "date and time"},
    {"#3106", kHost, "nct-23.1.8-3106", "message"},
    {"#3107", kHost, "nct-23.1.8-3107", "message box"},
    {"#3901", kState, "nct-23.1.9-3901 nct-13.1-partcount", "parts made and to make"},
    {"#4000", kState, "nct-23.1.13-4000", "number of the main program"},
    {"#4001", kState,
     "nct-23.1.14-#4001 nct-23.1.14-#4101 nct-23.1.14-#4102 nct-23.1.14-#4103 nct-23.1.14-#4107 "
     "nct-23.1.14-#4108 nct-23.1.14-#4109 nct-23.1.14-#4111 nct-23.1.14-#4113 nct-23.1.14-#4114 "
     "nct-23.1.14-#4115 nct-23.1.14-#4119 nct-23.1.14-#4120 nct-23.1.14-#4130",
     "codes and words last programmed"},
    {"#4201", kState,
     "nct-23.1.14-#4201 nct-23.1.14-#4301 nct-23.1.14-#4302 nct-23.1.14-#4303 nct-23.1.14-#4307 "
     "nct-23.1.14-#4308 nct-23.1.14-#4309 nct-23.1.14-#4311 nct-23.1.14-#4313 nct-23.1.14-#4314 "
     "nct-23.1.14-#4315 nct-23.1.14-#4319 nct-23.1.14-#4320 nct-23.1.14-#4330",
     "codes and words of the block that runs"},
    {"#4401", kState,
     "nct-23.1.14-#4401 nct-23.1.14-#4501 nct-23.1.14-#4502 nct-23.1.14-#4503 nct-23.1.14-#4507 "
     "nct-23.1.14-#4508 nct-23.1.14-#4509 nct-23.1.14-#4511 nct-23.1.14-#4513 nct-23.1.14-#4514 "
     "nct-23.1.14-#4515 nct-23.1.14-#4519 nct-23.1.14-#4520 nct-23.1.14-#4530",
     "codes and words of the interrupted block"},
    {"#5001", kState, "nct-23.1.15-absio nct-23.1.15-absmt nct-23.1.15-absot nct-23.1.15-abskp", "positions"},
    {"#5081", kState, "nct-23.1.16-tofs nct-23.1.17-dist", "length offset in force, distance to go"},
    {"#5101", kHost, "nct-23.1.17-sverr nct-23.1.17-mirtp", "lag of the servos, shift of the handwheel: 0"},
    {"#5201", kSim,
     "nct-23.1.19-#5201 nct-23.1.19-#5221 nct-23.1.19-#5241 nct-23.1.19-#5261 nct-23.1.19-#5281 "
     "nct-23.1.19-#5301 nct-23.1.19-#5321 nct-23.1.19-wzp",
     "work offsets"},
    {"#5500", kSim, "nct-23.1.19-fofs nct-23.1.19-fofsp nct-23.1.19-fofsval", "table of dynamic offsets"},
    {"#8500", kHost,
     "nct-23.1.21-#8500 nct-23.1.21-#8501 nct-23.1.21-#8502 nct-23.1.21-#8503 nct-23.1.21-#8504 "
     "nct-23.1.21-#8505 nct-23.1.21-#8531",
     "pallets: none"},
    {"#10001", kSim,
     "nct-23.1.18-#10001 nct-23.1.18-#11001 nct-23.1.18-#12001 nct-23.1.18-#13001 nct-23.1.18-#21001 "
     "nct-23.1.18-#22001",
     "milling offsets"},
    {"#23001", kSim,
     "nct-23.1.18-#23001 nct-23.1.18-#135001 nct-23.1.18-#136001 nct-23.1.18-#137001 nct-23.1.18-#138001",
     "turning offsets"},
    {"#120001", kSim,
     "nct-23.1.19-#120001 nct-23.1.19-#120011 nct-23.1.19-#120021 nct-23.1.19-#120031 nct-23.1.19-#120041 "
     "nct-23.1.19-#120051 nct-23.1.19-wrp",
     "basic rotations"},
    {"#_CNTBS", kState, "nct-23.1.11-cntbs", "block search, test, machine lock"},
    {"A B C U V W", kState, "nct-13.2-aux", "auxiliary functions at addresses that N1333 to N1335 name"},
    {"M groups", kState, "nct-13.1-groups", "M codes of one group exclude each other (N1341 to N1372)"},
    {"homing", kHost, "nct-1.3-ref nct-9-homing nct-10.2.3-jog",
     "axes are referenced from the start; nothing moves by hand"},
    {"axis swap", kHost, "nct-2.3-swap", "axes stay with the channel that the job gives them to"},
    {"limit switches", kHost, "nct-22.1-switch",
     "3018, 3019 never come: the simulated machine has no switches, travel beyond its limits is told as "
     "such"},
    {"PRM", kSim, "nct-24.2-PRM", "value of a parameter in formulas"},
    {"POPEN", kHost,
     "nct-23.2.13-POPEN nct-23.2.13-PCLOS nct-23.2.13-FOPEN nct-23.2.13-FCLOS nct-23.2.13-BPRNT "
     "nct-23.2.13-DPRNT",
     "files that programs write"},
});

}  // namespace

CodeTable dataTable() { return {{}, {}, kDataFeatures}; }

}  // namespace proveout::nc

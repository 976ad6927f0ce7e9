=== about
Further spindle codes of the machine builder are passed on; the monitoring of the speed has none in the simulation.
proves: nct-11.2-Mopt nct-11.6-monitor
=== settings
N0689 = 20
N0690 = 24
=== main
M20
M24
M30
=== truth
=== says
function code="M20"
function code="M24"
=== expect
file 0 main.nc
1: event function code="M20"
2: event function code="M24"
3: event end code="M30"
end of program: 3 blocks, 0 motions, 0 errors, 0 warnings

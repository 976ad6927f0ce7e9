=== about
proves: nct-23.3.4-Gself
=== settings
N1704 = 101
=== main
G101 X6
M30
=== sub SystemMacros/Channel1/O9010.nct
G101 X1
M99
=== says
error[nct-2123]
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O9010.nct
SystemMacros/Channel1/O9010.nct:1:1: error[nct-2123]: function not implemented: G101 is not a code of this control
    G101 X1
    ^~~~
    note: called from main.nc:1 by G101 (system call) #10=101 #24=6
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings

=== about
proves: nct-23.3-lookup
=== settings
N1704 = 101
=== main
G101 X6
M30
=== sub O9010.nct
G0 X1
M99
=== says
main.nc:1:1: error[nct-2147]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2147]: file not found: program SystemMacros/Channel1/O9010 is not among the programs given
    G101 X6
    ^~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

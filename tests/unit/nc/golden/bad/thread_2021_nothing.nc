=== about
G33 with no lead at all.
proves: nct-4.4-2021
=== main
S100 M3
G33 Z-10
M30
=== says
error[nct-2021]
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
main.nc:2:1: error[nct-2021]: thread cutting definition error: G33 needs F or E
    G33 Z-10
    ^~~~~~~~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings

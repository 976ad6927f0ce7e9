=== about
proves: nct-15.5.5-G38
=== main
G38 G1 X10 F100
M30
=== says
main.nc:1:1: error[nct-cutter-comp]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-cutter-comp]: G38 and G39 need G41 or G42
    G38 G1 X10 F100
    ^~~~~~~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

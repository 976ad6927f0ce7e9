=== about
proves: nct-15.5.6-G39
=== main
G1 X10 F100
G39
M30
=== says
main.nc:2:1: error[nct-cutter-comp]
=== expect
file 0 main.nc
1: feed from 0 0 0 to 10 0 0 F100 t6
main.nc:2:1: error[nct-cutter-comp]: G38 and G39 need G41 or G42
    G39
    ^~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings

=== about
The time is taken at the default speed, with a warning.
proves: nct-6.2.1-G95
=== main
G95 G1 X10 F0.1
M30
=== truth
10 0 0
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-spindle-stopped]: feed or dwell per turn while the spindle stands still: 1000 rpm is taken for the time
    G95 G1 X10 F0.1
    ^~~~~~~~~~~~~~~
1: feed from 0 0 0 to 10 0 0 F100 t6
2: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 1 warnings

=== settings
lenient = 1
=== main
G5.1 Q2 X0 Y0
G1 X5 F100
M30
=== truth
5 0 0
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-2123]: G5.1 (smooth interpolation) is not supported and left out
    G5.1 Q2 X0 Y0
    ^~~~
2: feed from 0 0 0 to 5 0 0 F100 t3
3: event end code="M30"
end of program: 3 blocks, 1 motions, 0 errors, 1 warnings

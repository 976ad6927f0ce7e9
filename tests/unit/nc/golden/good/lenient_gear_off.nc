=== about
A lenient run leaves out G80.8: the gear that it ends is never on.
=== settings
lenient = 1
=== main
G80.8
G0 X1
M30
=== truth
1 0 0
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-2123]: G80.8 (electronic gear off) is not supported and left out
    G80.8
    ^~~~~
2: rapid from 0 0 0 to 1 0 0 t0.004
3: event end code="M30"
end of program: 3 blocks, 1 motions, 0 errors, 1 warnings

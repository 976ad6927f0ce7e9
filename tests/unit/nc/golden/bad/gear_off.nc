=== about
The electronic gear is no part of what is simulated.
Truth: alarm 2123; nothing moves.
=== main
G80.8
G0 X1
M30
=== says
main.nc:1:1: error[nct-2123]
0 motions, 1 errors
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2123]: function not implemented: G80.8 (electronic gear off) is not supported
    G80.8
    ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

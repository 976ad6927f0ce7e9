O0100
G0 X1
O0200
G0 X2
M30
=== says
main.nc:3:1: error[nct-2017]
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:3:1: error[nct-2017]: illegal address O: a program number stands at the head of the text; subprograms are files of their own
    O0200
    ^~~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings

=== main
#101=12.5
G0 X#101 Q5
M30
=== says
main.nc:2:10: error[nct-2017]
=== expect
file 0 main.nc
main.nc:2:10: error[nct-2017]: illegal address Q in this block
    G0 X#101 Q5
             ^~
    note: X#101 = 12.5
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings

G0 X1 U2
M30
=== says
main.nc:1:7: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2017]: illegal address U: the axis is given twice in this block
    G0 X1 U2
          ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

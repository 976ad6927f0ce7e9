G0 X1 <abc>
M30
=== says
main.nc:1:7: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2017]: illegal address <>: a file name belongs to M98
    G0 X1 <abc>
          ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

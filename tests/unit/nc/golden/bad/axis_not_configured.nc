G0 X1 C90
M30
=== says
main.nc:1:7: error[nct-2035]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2035]: wrong axis data: axis C is not configured
    G0 X1 C90
          ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

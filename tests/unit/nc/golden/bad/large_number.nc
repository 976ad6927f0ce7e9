G0 X99999999999
M30
=== says
main.nc:1:4: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2002]: X data out of range
    G0 X99999999999
       ^~~~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

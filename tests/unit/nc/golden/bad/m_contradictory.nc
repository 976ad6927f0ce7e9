M8 M9
M30
=== says
main.nc:1:4: error[nct-contradictory-m]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-contradictory-m]: contradictory M codes: M8 and M9
    M8 M9
       ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

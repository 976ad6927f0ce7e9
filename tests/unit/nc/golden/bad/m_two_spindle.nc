S100 M3 M5
M30
=== says
main.nc:1:9: error[nct-contradictory-m]
=== expect
file 0 main.nc
main.nc:1:9: error[nct-contradictory-m]: contradictory M codes: M3 and M5
    S100 M3 M5
            ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

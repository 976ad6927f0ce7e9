=== about
The manual's group of coolant codes, N1341 = 8 and N1357 = 9.
proves: nct-13.1-groups
=== settings
N1341 = 8
N1357 = 9
=== main
M8 M9
M30
=== says
contradictory M codes: M8 and M9
=== expect
file 0 main.nc
main.nc:1:4: error[nct-contradictory-m]: contradictory M codes: M8 and M9
    M8 M9
       ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

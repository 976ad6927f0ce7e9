G1 F100
G4 P1 X5
M30
=== says
main.nc:2:7: error[nct-2017]
=== expect
file 0 main.nc
main.nc:2:7: error[nct-2017]: illegal address X in this block
    G4 P1 X5
          ^~
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings

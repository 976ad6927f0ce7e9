G4 P1 G53 X0
M30
=== says
main.nc:1:7: error[nct-group-clash]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-group-clash]: G4 and G53 cannot stand in one block
    G4 P1 G53 X0
          ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

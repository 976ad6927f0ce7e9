G4 P-1
M30
=== says
main.nc:1:4: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2002]: P data out of range: a dwell is not negative
    G4 P-1
       ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

G4 P2 M98
M30
=== says
main.nc:1:4: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2017]: illegal address P: it would belong to G4 and to another code
    G4 P2 M98
       ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

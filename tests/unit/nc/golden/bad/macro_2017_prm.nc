=== main
G0 X[PRM[1339]]
M30
=== says
error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2017]: illegal address PRM: parameters are read on the right of an assignment only
    G0 X[PRM[1339]]
       ^~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

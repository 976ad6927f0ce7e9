=== about
proves: nct-23.3.3-G66.1
=== main
G66.1 P11
G0 G90 X1
M30
=== sub O0011
M99
=== says
main.nc:2:4: error[nct-2017]
=== expect
file 0 main.nc
file 1 O0011
main.nc:2:4: error[nct-2017]: illegal address G: its variable has a value already
    G0 G90 X1
       ^~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings

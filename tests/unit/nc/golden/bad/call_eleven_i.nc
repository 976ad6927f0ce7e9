=== main
G65 P11 I0 I1 I2 I3 I4 I5 I6 I7 I8 I9 I10
M30
=== sub O0011
M99
=== says
main.nc:1:39: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:39: error[nct-2017]: illegal address I: its variable has a value already
    G65 P11 I0 I1 I2 I3 I4 I5 I6 I7 I8 I9 I10
                                          ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

=== about
proves: nct-23.3-args-N
=== main
N1 G65 P11 N2 N3
M30
=== sub O0011
M99
=== says
error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:15: error[nct-2017]: illegal address N: its variable has a value already
    N1 G65 P11 N2 N3
                  ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

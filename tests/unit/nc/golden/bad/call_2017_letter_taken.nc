=== about
proves: nct-23.3-args-mixed
=== main
G65 A2.12 B3.213 J36.9 J-12 E129.73 P11
M30
=== sub O0011
M99
=== says
error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:29: error[nct-2017]: illegal address E: its variable has a value already
    G65 A2.12 B3.213 J36.9 J-12 E129.73 P11
                                ^~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

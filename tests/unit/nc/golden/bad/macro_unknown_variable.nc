=== main
G0 X#34
M30
=== says
main.nc:1:4: error[nct-variable]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-variable]: the control has no variable #34
    G0 X#34
       ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

=== about
An axis twice in a block, once by its name; a configured U is no incremental X.
proves: nct-2.2-extname
=== settings
axis = Z1 4 linear parallel Z
axis = U 5 linear parallel X
max_errors = 5
=== main
G0 U5 X1
G0 Z1=5 Z1=6
G0 XI5 U2 V1
G53 U1 VI1
M30
=== says
main.nc:2:9: error[nct-duplicate-word]
main.nc:4:8: error[nct-2097]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 6 0 0 t0.02
main.nc:2:9: error[nct-duplicate-word]: two Z1 in one block
    G0 Z1=5 Z1=6
            ^~~~
3: rapid to 8 1 0 t0.02
main.nc:4:8: error[nct-2097]: illegal incremental movement on axis V: G53 is always absolute
    G53 U1 VI1
           ^~~
5: event end code="M30"
end of program: 5 blocks, 2 motions, 2 errors, 0 warnings

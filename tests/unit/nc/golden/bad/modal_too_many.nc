=== main
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
G66 P11
M30
=== sub O0011
M99
=== says
main.nc:17:1: error[nct-nesting]
=== expect
file 0 main.nc
file 1 O0011
main.nc:17:1: error[nct-nesting]: more than 16 modal macros are active
    G66 P11
    ^~~~~~~
alarm: 17 blocks, 0 motions, 1 errors, 0 warnings

=== main
G0 X1
M98 P11
M30
=== sub O0011.nc
G91 X1
M98 P11
M99
=== says
O0011.nc:2:1: error[nct-nesting]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
file 1 O0011.nc
1/1 depth 1: rapid to 2 0 0 t0.004
1/1 depth 2: rapid to 3 0 0 t0.004
1/1 depth 3: rapid to 4 0 0 t0.004
1/1 depth 4: rapid to 5 0 0 t0.004
1/1 depth 5: rapid to 6 0 0 t0.004
1/1 depth 6: rapid to 7 0 0 t0.004
1/1 depth 7: rapid to 8 0 0 t0.004
1/1 depth 8: rapid to 9 0 0 t0.004
1/1 depth 9: rapid to 10 0 0 t0.004
1/1 depth 10: rapid to 11 0 0 t0.004
1/1 depth 11: rapid to 12 0 0 t0.004
1/1 depth 12: rapid to 13 0 0 t0.004
1/1 depth 13: rapid to 14 0 0 t0.004
1/1 depth 14: rapid to 15 0 0 t0.004
1/1 depth 15: rapid to 16 0 0 t0.004
1/1 depth 16: rapid to 17 0 0 t0.004
O0011.nc:2:1: error[nct-nesting]: subprogram calls are nested deeper than 16
    M98 P11
    ^~~~~~~
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from O0011.nc:2 by M98
    note: called from main.nc:2 by M98
alarm: 34 blocks, 17 motions, 1 errors, 0 warnings

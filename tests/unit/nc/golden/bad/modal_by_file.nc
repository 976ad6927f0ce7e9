=== main
G66 <x.nc>
M30
=== sub O0011
M99
=== says
main.nc:1:5: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:5: error[nct-2017]: illegal address <>: G66 calls by number only
    G66 <x.nc>
        ^~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

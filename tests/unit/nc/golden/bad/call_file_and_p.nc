=== main
G65 P11 <x.nc>
M30
=== sub O0011
M99
=== says
main.nc:1:5: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:5: error[nct-2017]: illegal address P: G65 takes P or a file name
    G65 P11 <x.nc>
        ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

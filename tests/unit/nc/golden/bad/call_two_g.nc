=== main
G65 P11 G90
M30
=== sub O0011
M99
=== says
main.nc:1:9: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:9: error[nct-2017]: illegal address G: given twice
    G65 P11 G90
            ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

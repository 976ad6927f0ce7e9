=== main
G65 X1
M30
=== sub O0011
M99
=== says
main.nc:1:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: G65 needs a program number or a file name
    G65 X1
    ^~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

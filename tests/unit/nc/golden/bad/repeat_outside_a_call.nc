=== main
G0 X1 Y2 X3
M30
=== sub O0011
M99
=== says
main.nc:1:10: error[nct-duplicate-word]
=== expect
file 0 main.nc
main.nc:1:10: error[nct-duplicate-word]: two X in one block
    G0 X1 Y2 X3
             ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

G0 X1 X2
M30
=== says
main.nc:1:7: error[nct-duplicate-word]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-duplicate-word]: two X in one block
    G0 X1 X2
          ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

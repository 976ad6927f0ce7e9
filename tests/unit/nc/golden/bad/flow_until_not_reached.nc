=== settings
until_block = 20
=== main
G0 X1
M30
=== truth
1 0 0
=== says
main.nc:2:1: error[nct-until]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: error[nct-until]: the program ends here; the block to stop after was not reached
    M30
    ^~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings

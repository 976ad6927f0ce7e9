=== settings
until_block = 20
=== main
G0 X1
M30
=== truth
1 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: warning[nct-until]: the block to stop after was not reached
    M30
    ^~~
2: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 1 warnings

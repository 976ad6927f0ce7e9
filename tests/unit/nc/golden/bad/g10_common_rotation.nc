G10 L2 P0 I30
M30
=== says
main.nc:1:11: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:11: error[nct-2017]: illegal address I: the common offset has no rotation
    G10 L2 P0 I30
              ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

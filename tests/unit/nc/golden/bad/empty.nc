%
=== says
main.nc:1:1: error[nct-empty]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-empty]: main.nc: the program is empty
    %
    ^
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings

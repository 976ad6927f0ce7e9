/0 G0 X1
M30
=== says
main.nc:1:1: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2002]: / data out of range: optional skip is /1 to /9
    /0 G0 X1
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

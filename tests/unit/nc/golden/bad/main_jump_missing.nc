M99 P5
=== says
main.nc:1:1: error[nct-2125]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2125]: block N5 not found: main.nc
    M99 P5
    ^~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

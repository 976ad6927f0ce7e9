=== main
END1
M30
=== says
error[nct-2125]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2125]: block DO1 not found: loops start in pairs and do not overlap
    END1
    ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

=== about
DO1 END1 END1: the second END has no DO.
proves: nct-23.2.11-nesting
=== main
DO1
GOTO5
END1
N5 END1
M30
=== says
error[nct-2125]
=== expect
file 0 main.nc
main.nc:4:1: error[nct-2125]: block DO1 not found: loops start in pairs and do not overlap
    N5 END1
    ^~~~~~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings

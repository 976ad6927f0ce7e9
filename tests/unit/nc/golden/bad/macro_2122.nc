=== about
proves: nct-23.2.4-SQRT
=== main
#1=SQRT[-1]
M30
=== says
error[nct-2122]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2122]: root of a negative value: SQRT of -1
    #1=SQRT[-1]
       ^~~~~~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

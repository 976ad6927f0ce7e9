=== about
proves: nct-23.2.4-ASIN
=== main
#1=ASIN1.1
M30
=== says
error[nct-2117]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2117]: absolute value of the argument greater than 1: ASIN of 1.1
    #1=ASIN1.1
       ^~~~~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

=== about
proves: nct-23.2.4-LN
=== main
#1=LN0
M30
=== says
error[nct-2118]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2118]: value of the argument not positive: LN of 0
    #1=LN0
       ^~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

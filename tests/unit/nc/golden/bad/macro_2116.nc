=== about
proves: nct-23.2.4-TAN
=== main
#1=TAN[-270]
M30
=== says
error[nct-2116]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2116]: absolute value of the argument not less than 90: TAN of -270
    #1=TAN[-270]
       ^~~~~~~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

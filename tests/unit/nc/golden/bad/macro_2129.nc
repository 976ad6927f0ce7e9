=== about
proves: nct-23.2.3-range
=== main
#1=4294967296AND1
M30
=== says
error[nct-2129]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2129]: erroneous operation on #: an operand is beyond 32 bits
    #1=4294967296AND1
       ^~~~~~~~~~~~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

=== about
A bit takes nothing below 0.
proves: nct-23.1.7-out
=== main
#1100=-1
M30
=== says
error[nct-2092]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2092]: value limit exceeded: #1100
    #1100=-1
    ^~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

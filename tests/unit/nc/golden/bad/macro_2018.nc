=== about
proves: nct-23.2.12-AX
=== main
G0 AX[99]=1
M30
=== says
error[nct-2018]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2018]: wrong physical axis number 99
    G0 AX[99]=1
       ^~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

=== main
#1=[2+3
M30
=== says
error[nct-2121]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2121]: right bracket not found
    #1=[2+3
       ^~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

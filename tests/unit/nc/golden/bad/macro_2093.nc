=== about
proves: nct-23.2.2-div
=== main
#3=0
#100=5/#3
M30
=== says
error[nct-2093]
=== expect
file 0 main.nc
main.nc:2:6: error[nct-2093]: division by 0
    #100=5/#3
         ^~~~
    note: #100 is vacant
    note: #3 = 0
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings

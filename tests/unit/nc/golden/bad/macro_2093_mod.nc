=== about
proves: nct-23.2.2-MOD
=== main
#100=5MOD0
M30
=== says
error[nct-2093]
=== expect
file 0 main.nc
main.nc:1:6: error[nct-2093]: division by 0
    #100=5MOD0
         ^~~~~
    note: #100 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

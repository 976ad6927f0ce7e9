=== about
proves: nct-23.1.4-global
=== settings
N1702 = 530
N1703 = 540
=== main
#529=1
#541=2
G0 X#541
#530=1
M30
=== says
main.nc:4:1: error[nct-2161]
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 2 0 0 t0.008
main.nc:4:1: error[nct-2161]: variable #530 is read-only
    #530=1
    ^~~~~~
    note: #530 is vacant
alarm: 4 blocks, 1 motions, 1 errors, 0 warnings

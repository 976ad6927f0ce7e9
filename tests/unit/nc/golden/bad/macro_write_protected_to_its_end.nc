=== about
N1702 = 530 and N1703 = 540 protect #530 to #540, both of them.
proves: nct-23.1.4-global
=== settings
N1702 = 530
N1703 = 540
max_errors = 5
=== main
#529=1
#541=2
#530=1
#540=1
G0 X#529 Y#541
M30
=== truth
1 2 0
=== says
error[nct-2161]: variable #530
error[nct-2161]: variable #540
=== expect
file 0 main.nc
main.nc:3:1: error[nct-2161]: variable #530 is read-only
    #530=1
    ^~~~~~
    note: #530 is vacant
main.nc:4:1: error[nct-2161]: variable #540 is read-only
    #540=1
    ^~~~~~
    note: #540 is vacant
5: rapid from 0 0 0 to 1 2 0 t0.008
6: event end code="M30"
end of program: 6 blocks, 1 motions, 2 errors, 0 warnings

=== about
proves: nct-14.4.4-main
=== main
G0 X1
M99 P225
G0 X2
N225 G0 X3
M99
=== truth
1 0 0
3 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
4 N225: rapid to 3 0 0 t0.008
main.nc:5:1: note[nct-main-m99]: M99 in the main program starts it again: one pass is simulated
    M99
    ^~~
5: event end code="M99"
end of program: 4 blocks, 2 motions, 0 errors, 0 warnings

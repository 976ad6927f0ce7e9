=== about
proves: nct-14.4.1-O
=== main
(made by hand)
%
O0001 (PART)
G0 X1
M30
=== truth
1 0 0
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 1 0 0 t0.004
5: event end code="M30"
end of program: 2 blocks, 1 motions, 0 errors, 0 warnings

=== about
proves: nct-14.3-comment nct-1.1-O nct-14.4.1-O
=== main
%O1000 (HEADER)
N10 G0 X100 (positioning to X100)
N20 Z30
(N30 G1 Z60 F0.3
N40 X300)
M30
%
nothing here is read
=== truth
100 0 0
100 0 30
=== expect
file 0 main.nc
2 N10: rapid from 0 0 0 to 100 0 0 t0.4
3 N20: rapid to 100 0 30 t0.12
6: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings

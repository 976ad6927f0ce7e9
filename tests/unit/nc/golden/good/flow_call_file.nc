=== about
proves: nct-14.4.2-M98file
=== main
M98 <sub\part two.prg> L2
M30
=== sub part two.prg
G91 G0 X1
M99
=== truth
1 0 0
2 0 0
=== expect
file 0 main.nc
file 1 part two.prg
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
1/1 depth 1: rapid to 2 0 0 t0.004
2: event end code="M30"
end of program: 6 blocks, 2 motions, 0 errors, 0 warnings

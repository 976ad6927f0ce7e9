=== about
proves: nct-23.1.3-local nct-23.1.4-global
=== main
#1=1
#33=33
#100=10.25
#499=2
#500=3
#999=4
M98 P11
G0 X#1 Y#33 (the subprogram shares the locals)
X#100 Y#499
X#500 Y#999
M30
=== sub O0011
#1=5
#499=7
M99
=== truth
rapid 5 33 0
rapid 10.25 7 0
rapid 3 4 0
=== expect
file 0 main.nc
file 1 O0011
8: rapid from 0 0 0 to 5 33 0 t0.132
9: rapid to 10.25 7 0 t0.104
10: rapid to 3 4 0 t0.029
11: event end code="M30"
end of program: 14 blocks, 3 motions, 0 errors, 0 warnings

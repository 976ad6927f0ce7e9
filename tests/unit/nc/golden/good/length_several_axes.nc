=== about
proves: nct-15.3-G44 nct-15.3-G43 nct-15.3-G49 nct-3-G43 nct-3-G44 nct-3-G49
=== settings
H15 = 15
H16 = 16
H27 = 27
N1416.ZAX = 0
=== main
G0 G44 X120 Z250 H27
G49 X120 Z250
G43 Z250 H15
Y310 H16
M30
=== truth
93 0 223
120 0 250
120 0 265
120 326 265
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 93 0 223 t0.892
2: rapid to 120 0 250 t0.108
3: rapid to 120 0 265 t0.06
4: rapid to 120 326 265 t1.304
5: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings

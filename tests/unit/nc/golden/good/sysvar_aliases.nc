=== about
One cell by its numbers and its name.
proves: nct-23.1.19-wzp nct-23.1.19-wrp nct-23.1.19-fofs nct-23.1.15-absio nct-23.1.5-notation nct-23.1.7-out
=== main
#7941=1
#103402=2
#_WZP50[1]=3
#101001=4
#7021=5
#_WZP99[2]=6
G0 X#103351 Y#_WZP48[1] Z0
X#_WZP49[2] Y#103451 Z#7001
X#101051 Y#105902 Z#_WZP2[1]
#100=#100001
X#5001 Y#100 Z#_ABSIO[1]
#5661=7
#117051=8
#_FOFS2[1]=9
X#117401 Y#5521 Z#5541
X#_FOFS8[1] Y#_FOFS1[1] Z#117101
#120071=10
X#_WRP2[1] Y0 Z0
#1100=0.5
#1102=1
#1103=0
X#1100 Y#1132 Z#1101
M30
=== truth
1 1 0
2 3 4
5 6 5
5 5 5
7 8 9
10 0 0
1 5 0
=== expect
file 0 main.nc
7: rapid from 0 0 0 to 1 1 0 t0.004
8: rapid to 2 3 4 t0.016
9: rapid to 5 6 5 t0.012
11: rapid to 5 5 5 t0.004
15: rapid to 7 8 9 t0.016
18: rapid to 10 0 0 t0.036
22: rapid to 1 5 0 t0.036
23: event end code="M30"
end of program: 23 blocks, 7 motions, 0 errors, 0 warnings

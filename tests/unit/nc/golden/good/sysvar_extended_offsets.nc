=== about
Extended work systems by variable: P1 to P48 by low numbers, all 99 by high ones and names; rotations too. The table of
dynamic offsets is kept and read back; none is in force.
proves: nct-23.1.19-wzp nct-23.1.19-wrp nct-23.1.19-fofs nct-23.1.19-fofsp nct-23.1.19-fofsval
=== main
#103351=5
#7942=6
#_WZP48[3]=7
G54.1 P48 G0 X0 Y0 Z0
X#7941 Y#103352 Z#7943
#103401=8
#_WZP49[2]=9
#105903=10
G54.1 P49 X0 Y0 Z0
G54.1 P99 X#_WZP49[1] Y#103402 Z0
#120071=90
#_WZP2[1]=100
G54.1 P2 X1 Y0 Z0
X#_WRP2[1] Y#121041 Z#120073
#117401=11
#_FOFS8[2]=12
G54 X#5661 Y#5662 Z#_FOFSP
#5521=13
X#117051 Y#_FOFS1[1] Z#5500
X#5501 Y#117002 Z#_FOFSVAL[3]
M30
=== truth
5 6 7
10 12 14
8 9 0
8 9 10
100 1 0
100 90 0
11 12 0
13 13 0
0 0 0
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 5 6 7 t0.028
5: rapid to 10 12 14 t0.028
9: rapid to 8 9 0 t0.056
10: rapid to 8 9 10 t0.04
13: rapid to 100 1 0 t0.368
14: rapid to 100 90 0 t0.356
17: rapid to 11 12 0 t0.356
19: rapid to 13 13 0 t0.008
20: rapid to 0 0 0 t0.052
21: event end code="M30"
end of program: 21 blocks, 9 motions, 0 errors, 0 warnings

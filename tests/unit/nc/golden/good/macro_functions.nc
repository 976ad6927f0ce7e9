=== about
Digest nct-5, sections 4 and 5.
proves: nct-23.2.4-SQRT nct-23.2.4-SIN nct-23.2.4-COS nct-23.2.4-TAN nct-23.2.4-ASIN nct-23.2.4-ACOS nct-23.2.4-ATAN nct-23.2.4-EXP
nct-23.2.4-LN nct-23.2.5-ABS nct-23.2.5-FIX nct-23.2.5-FUP
=== main
#100=12
#101=SQRT[#100+4]
G0 X#101
#101=0.25
G1 X[SIN30-#101] F1000
#1=20
#2=40
#102=COS[#1+#2]
X#102
#2=3
#1=TAN[#2*15]
X#1
#101=ASIN[-0.5]
X#101
#101=ACOS[-0.5]
X#101
#101=ATAN[-0.5]
X#101
#100=EXP1
X#100
#100=LN2.718281828
X#100
X[ABS[-3.1]]
X[ABS[5.25]]
#130=ABS[0]
X#130
#130=FIX4.8
X#130
#131=FIX[-6.7]
X#131
#130=FUP12.1
X#130
#131=FUP[-7.3]
X#131
M30
=== truth
rapid 4 0 0
feed 0.25 0 0
feed 0.5 0 0
feed 1 0 0
feed -30 0 0
feed 120 0 0
feed -26.5651 0 0
feed 2.7183 0 0
feed 1 0 0
feed 3.1 0 0
feed 5.25 0 0
feed 0 0 0
feed 4 0 0
feed -6 0 0
feed 13 0 0
feed -8 0 0
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 4 0 0 t0.016
5: feed to 0.25 0 0 F1000 t0.225
9: feed to 0.5 0 0 F1000 t0.015
12: feed to 1 0 0 F1000 t0.03
14: feed to -30 0 0 F1000 t1.86
16: feed to 120 0 0 F1000 t9
18: feed to -26.5651 0 0 F1000 t8.7939
20: feed to 2.7183 0 0 F1000 t1.757
22: feed to 1 0 0 F1000 t0.1031
23: feed to 3.1 0 0 F1000 t0.126
24: feed to 5.25 0 0 F1000 t0.129
26: feed to 0 0 0 F1000 t0.315
28: feed to 4 0 0 F1000 t0.24
30: feed to -6 0 0 F1000 t0.6
32: feed to 13 0 0 F1000 t1.14
34: feed to -8 0 0 F1000 t1.26
35: event end code="M30"
end of program: 35 blocks, 16 motions, 0 errors, 0 warnings

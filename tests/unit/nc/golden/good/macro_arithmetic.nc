=== about
Digest nct-5, sections 1, 2 and 6.
proves: nct-23.2-formula nct-23.2.1-assign nct-23.2.2-neg nct-23.2.2-add nct-23.2.2-sub nct-23.2.2-mul nct-23.2.2-div nct-23.2.2-MOD
nct-23.2.6-precedence nct-23.2.6-brackets nct-23.1.1-ref
=== main
#1=10
#3=4
#12=2.5
G90 G0 X-#12 (negation)
#1=#1+3.25
X#1
#100=#1-#3
X#100
#100=#100*5.65
X#100
#100=542.23/#3
X#100
#120=27MOD4
X#120
G1 Z[25.34-2.48] F100
G0 X[[#100+2]/4] Y100
#100=[#3+#12*5.27]/4.1
X#100
#110=1+2*COS60 (function, then product, then sum)
X#110
#121=50
#122=20
#123=2
#125=30
#126=0.5
#120=COS[[[#121-#122]*#123+#125]*#126]*100 (cosine of 45 degrees)
X#120
#120=[[1+2]*3]
X#120
M30
=== truth
rapid -2.5 0 0
rapid 13.25 0 0
rapid 9.25 0 0
rapid 52.2625 0 0
rapid 135.5575 0 0
rapid 3 0 0
feed 3 0 22.86
rapid 34.3894 100 22.86
rapid 4.1890 100 22.86
rapid 2 100 22.86
rapid 70.7107 100 22.86
rapid 9 100 22.86
=== expect
file 0 main.nc
4: rapid from 0 0 0 to -2.5 0 0 t0.01
6: rapid to 13.25 0 0 t0.063
8: rapid to 9.25 0 0 t0.016
10: rapid to 52.2625 0 0 t0.1721
12: rapid to 135.5575 0 0 t0.3332
14: rapid to 3 0 0 t0.5302
15: feed to 3 0 22.86 F100 t13.716
16: rapid to 34.3894 100 22.86 t0.4
18: rapid to 4.189 100 22.86 t0.1208
20: rapid to 2 100 22.86 t0.0088
27: rapid to 70.7107 100 22.86 t0.2748
29: rapid to 9 100 22.86 t0.2468
30: event end code="M30"
end of program: 30 blocks, 12 motions, 0 errors, 0 warnings

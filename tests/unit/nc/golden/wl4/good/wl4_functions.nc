=== about
Functions and operators with values known by closed forms.
proves: wl4-9.3.1-SIN wl4-9.3.1-COS wl4-9.3.1-TAN wl4-9.3.1-ASIN wl4-9.3.1-ACOS wl4-9.3.1-ATAN wl4-9.3.1-EXP wl4-9.3.1-LN wl4-9.3.1-FIX wl4-9.3.1-FUP wl4-9.3.1-ROUND wl4-9.3.1-SQRT wl4-9.3.2-pow wl4-9.3.2-mod wl4-9.3.2-AND wl4-9.3.2-OR wl4-9.3.2-XOR wl4-9.3.2-eq wl4-9.3.2-ne wl4-9.3.2-le wl4-9.1-ind wl4-9.1-glob
=== settings
control = wl4-mill
=== main
%FUNC
G54 G0
X(SIN(30)*100) Y(COS(60)*100) Z(TAN(45)*100)
X(ASIN(0.5)) Y(ACOS(0.5)) Z(ATAN(-1)/(-1))
X(EXP(1)) Y(LN(EXP(2))) Z(ATAN(1))
X(FIX(2.7)) Y(FUP(2.1)) Z(ROUND(2.5))
X(FIX(-2.7)) Y(FUP(-2.1)) Z(ROUND(-2.5))
X(SQRT(144)) Y(2**10) Z(-7 MOD 3)
X(1 AND 0) Y(1 OR 0) Z(1 XOR 1)
X(2==2) Y(2<>2) Z(2<=2)
#20=5 #5=42 #31=7
X#(#20) Y##20 Z#(ABS(3-34))
M30
%
=== truth
rapid 50 50 100
rapid 30 60 -135
rapid 2.7183 2 45
rapid 2 3 3
rapid -3 -2 -3
rapid 12 1024 2
rapid 0 1 0
rapid 1 0 1
rapid 42 42 7
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 50 50 100 t0.4
4: rapid to 30 60 -135 t0.94
5: rapid to 2.7183 2 45 t0.72
6: rapid to 2 3 3 t0.168
7: rapid to -3 -2 -3 t0.024
8: rapid to 12 1024 2 t4.104
9: rapid to 0 1 0 t4.092
10: rapid to 1 0 1 t0.004
12: rapid to 42 42 7 t0.168
13: event end code="M30"
end of program: 12 blocks, 9 motions, 0 errors, 0 warnings

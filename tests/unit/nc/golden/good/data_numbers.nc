=== about
proves: nct-1.1-word nct-5.5-decimals nct-1.1-XYZUVW
=== main
g0 x+12.5 y.032 z-.5
X0.320Y.32Z007
X325 Y-0 Z 1
x1.5 y2(inside)z3
M30
=== truth
12.5 0.032 -0.5
0.32 0.32 7
325 0 1
1.5 2 3
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 12.5 0.032 -0.5 t0.05
2: rapid to 0.32 0.32 7 t0.0487
3: rapid to 325 0 1 t1.2987
4: rapid to 1.5 2 3 t1.294
5: event end code="M30"
end of program: 5 blocks, 4 motions, 0 errors, 0 warnings

=== about
Digest nct-5, sections 18 and 19: T, B and two letters call subprograms, their values in #199, #196, #191, #192.
proves: nct-23.3.7-ABCST nct-23.3.8-ASCII
=== settings
N1746.TM = 1
N1746.BM = 1
N1747 = 86
N1751 = 700
N1748 = 81
N1752 = 701
=== main
G0 X10 T7
X#199
B-30 X8
X#196
V3 X9 Q1.5
X#191
Y#192
M30
=== sub SystemMacros/Channel1/O9034.nct
G91 X1 T#199
G90
M99
=== sub SystemMacros/Channel1/O9031.nct
Y5
M99
=== sub SystemMacros/Channel1/O0700.nct
M99
=== sub SystemMacros/Channel1/O0701.nct
M99
=== truth
rapid 10 0 0
rapid 11 0 0
rapid 7 0 0
rapid 8 0 0
rapid 8 5 0
rapid -30 5 0
rapid 9 5 0
rapid 3 5 0
rapid 3 1.5 0
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O9034.nct
1: rapid from 0 0 0 to 10 0 0 t0.04
1/1 depth 1: rapid to 11 0 0 t0.004
2: rapid to 7 0 0 t0.016
file 2 SystemMacros/Channel1/O9031.nct
3: rapid to 8 0 0 t0.004
2/1 depth 1: rapid to 8 5 0 t0.02
4: rapid to -30 5 0 t0.152
file 3 SystemMacros/Channel1/O0700.nct
file 4 SystemMacros/Channel1/O0701.nct
5: rapid to 9 5 0 t0.156
6: rapid to 3 5 0 t0.024
7: rapid to 3 1.5 0 t0.014
8: event end code="M30"
end of program: 15 blocks, 9 motions, 0 errors, 0 warnings

=== about
Digest nct-5, section 3.
proves: nct-23.2.3-NOT nct-23.2.3-OR nct-23.2.3-XOR nct-23.2.3-AND nct-23.2.3-range
=== main
#100=305419896 (12345678h)
#101=16777215AND#100
G0 X[#101/10000]
#102=-1694498816
#100=#101XOR#102 (9B345678h as a signed number)
X[#100/1000000]
#100=NOT0
X#100
#100=12OR3
X#100
#100=12XOR10
X#100
#100=12AND10
X#100
#100=6.6AND7
X#100
M30
=== truth
rapid 343.0008 0 0
rapid -1691.0688 0 0
rapid -1 0 0
rapid 15 0 0
rapid 6 0 0
rapid 8 0 0
rapid 7 0 0
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 343.0008 0 0 t1.372
6: rapid to -1691.0688 0 0 t8.1363
8: rapid to -1 0 0 t6.7603
10: rapid to 15 0 0 t0.064
12: rapid to 6 0 0 t0.036
14: rapid to 8 0 0 t0.008
16: rapid to 7 0 0 t0.004
17: event end code="M30"
end of program: 17 blocks, 7 motions, 0 errors, 0 warnings

=== about
Bits that steer automatic mode: by number, by name. Suppressed exact stop shortens the path of two equal lines in exact stop
mode: 2 (d/v + v/a) becomes 2 d/v + v/a.
proves: nct-23.1.10-3003 nct-23.1.10-3004 nct-23.1.11-cntbs
=== settings
acceleration = 1000 1000 1000
test_mode = 1
=== main
#3003=1
G0 X#_M_SBK Y#3003 Z#_CNTL1
#_M_SBK=0
#3004=5
X#_M_FHD Y#_M_OV Z#_M_EST
#_M_OV=0.5
#_M_EST=0
X#3004 Y#3003 Z#_CNTL2
X#_CNTBS Y#_TEST Z[#_BSEARCH+#_MCHLOCK]
X0 Y0 Z0
G61 G1 F6000
#3004=0
#3001=0
X20
X40
#100=#3001
#3004=4
#3001=0
X60
X80
#101=#3001
G0 X#100 Y#101
M30
=== truth
1 1 1
1 0 1
3 0 3
2 1 0
0 0 0
20 0 0
40 0 0
60 0 0
80 0 0
600 500 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 1 1 t0.0632
5: rapid to 1 0 1 t0.0632
8: rapid to 3 0 3 t0.0894
9: rapid to 2 1 0 t0.1095
10: rapid to 0 0 0 t0.0894
14: feed to 20 0 0 F6000 t0.3
15: feed to 40 0 0 F6000 t0.3
19: feed to 60 0 0 F6000 t0.25
20: feed to 80 0 0 F6000 t0.25
22: rapid to 600 500 0 t2.33
23: event end code="M30"
end of program: 23 blocks, 10 motions, 0 errors, 0 warnings

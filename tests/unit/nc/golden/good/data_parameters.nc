=== about
Parameters written by number and read back: of the channel, of a spindle, a bit, added. N is data here and no
block number: GOTO107 finds the block behind the data. The arc of N107 is accepted without a word with N1339 = 0.5 only; a job that
does not give N1339 has 2 mm in force.
proves: nct-24.1-G10L52 nct-24.1-G11 nct-24.1-RI nct-24.2-PRM nct-24-kinds nct-3-G11 nct-3-G10
=== main
GOTO107
G10 L52
N107 P4 Q0 R1
G11
N107 #100=PRM[1339]
G10 L52
N0607 P4 Q1 R0
N1339 (P1) R0.5
N1403 (P1) Q1 R1
N1400 RI-99
N1405 P1 R#100 (a formula)
G11
#101=PRM[607,1]/[4]
#102=PRM[1339]/[1]
#103=PRM[1403,1]/[1]
#104=PRM[1400]
#105=PRM[607,1]/[5]
#106=PRM[1405]
G0 X#101 Y#102 Z#103
X#104 Y#105 Z#106
G0 X10 Y0 Z0
G2 X-9.8 I-10 F100
M30
=== truth
0 0.5 1
900 1 2
10 0 0
-9.8 0 0 sweep -180
=== expect
file 0 main.nc
19: rapid from 0 0 0 to 0 0.5 1 t0.004
20: rapid to 900 1 2 t3.6
21: rapid to 10 0 0 t3.56
22: feed arc to -9.8 0 0 center 0 0 0 normal 0 0 1 sweep -180 F99.002 t18.8496
23: event end code="M30"
end of program: 20 blocks, 4 motions, 0 errors, 0 warnings

=== about
Inputs and outputs of the PLC: bits, all bits as one number, three numbers. Bits take values up to 1 as 1. A negative number
is stored modulo 2^32: the pattern 9B345678h of the manual.
proves: nct-23.1.7-in nct-23.1.7-out
=== settings
plc_bit0 = 1
plc_bit5 = 1
plc_bit31 = 1
plc_number2 = 2.5
=== main
G0 X#1000 Y#1001 Z#_UI[5]
X#1034 Y#_UIL[2] Z#_UI[31]
X[#1032-2147483648] Y#1033 Z[#_UIL[0]-2147483648]
#1132=5
X#1100 Y#1101 Z#1102
#1103=0.4
X#1132 Y#_UO[3] Z#_UOL[0]
#1100=#0
#1134=-7.25
X#1132 Y#1134 Z#_UOL[2]
#1132=305419896
#1132=[16777215AND#1132]XOR[-1694498816]
X[FIX[#1132/16777216]] Y[#1132-FIX[#1132/65536]*65536]
#1132=-1
X[#1132-4294967295] Y#1131 Z0
M30
=== truth
1 0 1
2.5 2.5 1
33 0 33
1 0 1
13 1 13
12 -7.25 -7.25
155 22136 *
0 1 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 1 t0.004
2: rapid to 2.5 2.5 1 t0.01
3: rapid to 33 0 33 t0.128
5: rapid to 1 0 1 t0.128
7: rapid to 13 1 13 t0.048
10: rapid to 12 -7.25 -7.25 t0.081
13: rapid to 155 22136 -7.25 t88.573
15: rapid to 0 1 0 t88.54
16: event end code="M30"
end of program: 16 blocks, 8 motions, 0 errors, 0 warnings

=== about
Digest nct-5, section 8.
proves: nct-23.2.8-GOTO nct-23.2.9-IF-GOTO
=== main
#100=52.28
#101=16.87
IF[#100GT#101] GOTO210
G0 X999
N210 G0 X0 Y100 Z20
#1=100
#2=60
GOTO[#1+#2]
X999
N10 X5
GOTO#3
X999
N160 G0 X100
IF[#1LT#2] GOTO 210
#3=170
GOTO10 (backwards)
N170 X7
IF[1EQ1] THEN GOTO180
X999
/N180 X8
M30
=== truth
rapid 0 100 20
rapid 100 100 20
rapid 5 100 20
rapid 7 100 20
rapid 8 100 20
=== expect
file 0 main.nc
5 N210: rapid from 0 0 0 to 0 100 20 t0.4
13 N160: rapid to 100 100 20 t0.4
10 N10: rapid to 5 100 20 t0.38
17 N170: rapid to 7 100 20 t0.008
20 N180: rapid to 8 100 20 t0.004
21: event end code="M30"
end of program: 17 blocks, 5 motions, 0 errors, 0 warnings

=== about
Message boxes (manual 23.1.8): text with values, the answer of the person: OK to boxes 100 to 199 and yes to 200 to 299
unless told otherwise. Answer yes goes on at N10, everything else at N20.
proves: nct-23.1.8-3107
=== settings
answer201 = 3
answer150 = 0
=== main
#140=0.3458
#141=-0.9123
#3107=100(Measured result\nX length: #140[53]\nY length: #141[53])
G0 X#3107
#_MSGBOX=200(Tool wear\nX wear on diameter: #140[53]\nZ wear: #141[53]\nWrite the new offset?)
IF[[#_MSGBOX]EQ2] GOTO10
GOTO20
N10 Y10
N20 #3107=201(Once more?)
IF[#3107EQ2] GOTO30
Y20
N30 X#3107
#3107=150
Z[5+#3107]
M30
=== truth
1 0 0
1 10 0
1 20 0
3 20 0
3 20 5
=== says
code="01610000" text="Measured result\u000aX length:      0.346\u000aY length: -    0.912"
text="Tool wear\u000aX wear on diameter:      0.346\u000aZ wear: -    0.912\u000aWrite the new offset?" answer=2
=== expect
file 0 main.nc
3: event message kind="box" number=100 code="01610000" text="Measured result\u000aX length:      0.346\u000aY length: -    0.912" answer=1
4: rapid from 0 0 0 to 1 0 0 t0.004
5: event message kind="box" number=200 code="01620000" text="Tool wear\u000aX wear on diameter:      0.346\u000aZ wear: -    0.912\u000aWrite the new offset?" answer=2
8 N10: rapid to 1 10 0 t0.04
9 N20: event message kind="box" number=201 code="01620100" text="Once more?" answer=3
11: rapid to 1 20 0 t0.04
12 N30: rapid to 3 20 0 t0.008
13: event message kind="box" number=150 code="01615000" text="" answer=0
14: rapid to 3 20 5 t0.02
15: event end code="M30"
end of program: 14 blocks, 5 motions, 0 errors, 0 warnings

=== about
Two tools of one type: row 2 has one use left; behind it row 9 comes.
proves: nct-12.3.1-select nct-12.4.1-G10L75P1
=== main
G10 L75 P1
N2
T81501070 Q10001 A0 B2 C199 L200 H12 D23
N9
T81501070 Q10001 A0 B1 C0 L180 H13 D14
N10 T1 Q1 B1 L9
G11
T81501070 M6
G0 X#8401
T1 M6
T81501070 M6
X#8401
M30
=== truth
2 0 0 T 81501070
9 0 0 T 81501070
=== expect
file 0 main.nc
8: event tool tool=81501070 row=2
9: rapid from 0 0 0 to 2 0 0 t0.008
10: event tool tool=1 row=10
11: event tool tool=81501070 row=9
12: rapid to 9 0 0 t0.028
13: event end code="M30"
end of program: 13 blocks, 2 motions, 0 errors, 0 warnings

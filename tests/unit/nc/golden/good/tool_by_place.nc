=== about
M62: a tool by its magazine and pocket, even at the end of its life. Shapes are taken and only kept.
proves: nct-12.5.2-M62 nct-12.3.2-location nct-12.4.5-G10L77P6 nct-12.3.3-shape
=== settings
N2924 = 62
=== main
G10 L75 P1
N1 T500 Q1 B3 C9 L9
N2 T600 Q1 B2 L9
G11
G10 L76 P1
N1 P12 R1
N1 P14 R2
N10 R2
G11
G10 L77 P6
N5 P4 Q1 R0 S0 T1
G11
G1 F100 X#8401
M62 T10012
M6
X#8401
T100001 M62
M6
X#8401
M30
=== truth
2 0 0 T 0
1 0 0 T 500
=== expect
file 0 main.nc
13: feed from 0 0 0 to 2 0 0 F100 t1.2
14: event function code="M62"
15: event tool tool=500 row=1
16: feed to 1 0 0 F100 t0.6
17: event function code="M62"
18: event tool tool=500 row=1
20: event end code="M30"
end of program: 20 blocks, 2 motions, 0 errors, 0 warnings

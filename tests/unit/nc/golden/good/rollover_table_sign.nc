=== about
The manual's table with N0107.ABS: the sign of an absolute angle is the direction. From 0: C30, C390, C750 turn by 30,
C-30, C-390, C-750 by -330; from 30: C0 turns by 330, C-360 by -30.
proves: nct-5.6-sign nct-5.6-inc
=== settings
axis = C 4 rotary carries nothing
N0107.REN.4 = 1
N0107.ABS.4 = 1
=== main
G0 G90 C30
G91 C-30
G90 C390
G91 C-30
G90 C750
G91 C-30
G90 C-30
G91 C330
G90 C-390
G91 C330
G90 C-750
#100=#5004
G91 C330
G90 C30
C0
G91 C30
G90 C-360
#101=#5004
G91 C30
C390
C750
G90 X#100 Y#101
M30
=== truth
0 0 0 rotary 30
0 0 0 rotary 0
0 0 0 rotary 30
0 0 0 rotary 0
0 0 0 rotary 30
0 0 0 rotary 0
0 0 0 rotary -330
0 0 0 rotary 0
0 0 0 rotary -330
0 0 0 rotary 0
0 0 0 rotary -330
0 0 0 rotary 0
0 0 0 rotary 30
0 0 0 rotary 360
0 0 0 rotary 390
0 0 0 rotary 360
0 0 0 rotary 390
0 0 0 rotary 420
0 0 0 rotary 450
30 0 0
=== expect
file 0 main.nc
main.nc:1:8: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G0 G90 C30
           ^~~
1: rapid from 0 0 0 to 0 0 0 C 0 to 30 t0.12
2: rapid to 0 0 0 C 30 to 0 t0.12
3: rapid to 0 0 0 C 0 to 30 t0.12
4: rapid to 0 0 0 C 30 to 0 t0.12
5: rapid to 0 0 0 C 0 to 30 t0.12
6: rapid to 0 0 0 C 30 to 0 t0.12
7: rapid to 0 0 0 C 0 to -330 t1.32
8: rapid to 0 0 0 C -330 to 0 t1.32
9: rapid to 0 0 0 C 0 to -330 t1.32
10: rapid to 0 0 0 C -330 to 0 t1.32
11: rapid to 0 0 0 C 0 to -330 t1.32
13: rapid to 0 0 0 C -330 to 0 t1.32
14: rapid to 0 0 0 C 0 to 30 t0.12
15: rapid to 0 0 0 C 30 to 360 t1.32
16: rapid to 0 0 0 C 360 to 390 t0.12
17: rapid to 0 0 0 C 390 to 360 t0.12
19: rapid to 0 0 0 C 360 to 390 t0.12
20: rapid to 0 0 0 C 390 to 420 t0.12
21: rapid to 0 0 0 C 420 to 450 t0.12
22: rapid to 30 0 0 C 450 to 450 t0.12
23: event end code="M30"
end of program: 23 blocks, 20 motions, 0 errors, 0 warnings

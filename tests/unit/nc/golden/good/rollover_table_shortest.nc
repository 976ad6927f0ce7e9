=== about
The manual's table with N0107.ASH: each absolute angle from 0; the position that is read lies within a turn.
proves: nct-5.6-short nct-5.6-inc
=== settings
axis = C 4 rotary carries nothing
N0107.REN.4 = 1
N0107.ASH.4 = 1
=== main
G0 G90 C210
#100=#5004
G91 C150
G90 C570
#101=#5004
G91 C150
G90 C930
G91 C150
G90 C-210
#102=#5004
G91 C-150
G90 C-570
G91 C-150
G90 C-930
G91 C-150
C30
C390
C750
G90 X#100 Y#101 Z#102
M30
=== truth
0 0 0 rotary -150
0 0 0 rotary 0
0 0 0 rotary -150
0 0 0 rotary 0
0 0 0 rotary -150
0 0 0 rotary 0
0 0 0 rotary 150
0 0 0 rotary 0
0 0 0 rotary 150
0 0 0 rotary 0
0 0 0 rotary 150
0 0 0 rotary 0
0 0 0 rotary 30
0 0 0 rotary 60
0 0 0 rotary 90
210 210 150
=== expect
file 0 main.nc
main.nc:1:8: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G0 G90 C210
           ^~~~
1: rapid from 0 0 0 to 0 0 0 C 0 to -150 t0.6
3: rapid to 0 0 0 C -150 to 0 t0.6
4: rapid to 0 0 0 C 0 to -150 t0.6
6: rapid to 0 0 0 C -150 to 0 t0.6
7: rapid to 0 0 0 C 0 to -150 t0.6
8: rapid to 0 0 0 C -150 to 0 t0.6
9: rapid to 0 0 0 C 0 to 150 t0.6
11: rapid to 0 0 0 C 150 to 0 t0.6
12: rapid to 0 0 0 C 0 to 150 t0.6
13: rapid to 0 0 0 C 150 to 0 t0.6
14: rapid to 0 0 0 C 0 to 150 t0.6
15: rapid to 0 0 0 C 150 to 0 t0.6
16: rapid to 0 0 0 C 0 to 30 t0.12
17: rapid to 0 0 0 C 30 to 60 t0.12
18: rapid to 0 0 0 C 60 to 90 t0.12
19: rapid to 210 210 150 C 90 to 90 t0.84
20: event end code="M30"
end of program: 20 blocks, 16 motions, 0 errors, 0 warnings

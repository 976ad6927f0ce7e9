=== about
-0 is 0, and 0 is positive: from 350 it is 10 on. The sign wins over the shorter way.
proves: nct-5.6-sign
=== settings
axis = C 4 rotary carries nothing
N0107.REN.4 = 1
N0107.ABS.4 = 1
N0107.ASH.4 = 1
=== main
G0 G90 C350
C-0
M30
=== truth
0 0 0 rotary 350
0 0 0 rotary 360
=== expect
file 0 main.nc
main.nc:1:8: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G0 G90 C350
           ^~~~
1: rapid from 0 0 0 to 0 0 0 C 0 to 350 t1.4
2: rapid to 0 0 0 C 350 to 360 t0.04
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings

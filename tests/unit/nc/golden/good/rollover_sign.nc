=== about
The sign of an absolute word is the direction: from 0 C30, C390 and C750 turn by +30, C-30 by -330; from 30 C0 turns
by +330, C-360 by -30. The sign wins over the shorter way.
proves: nct-5.6-sign
=== settings
axis = C 4 rotary carries nothing
N0107.REN.4 = 1
N0107.ABS.4 = 1
N0107.ASH.4 = 1
=== main
G90 C30
C0
C390
C-30
C-360
C-30
M30
=== truth
* * * rotary 30
* * * rotary 360
* * * rotary 390
* * * rotary 360
* * * rotary 30
=== expect
file 0 main.nc
main.nc:1:5: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G90 C30
        ^~~
1: rapid from 0 0 0 to 0 0 0 C 0 to 30 t0.12
2: rapid to 0 0 0 C 30 to 360 t1.32
3: rapid to 0 0 0 C 360 to 390 t0.12
5: rapid to 0 0 0 C 390 to 360 t0.12
6: rapid to 0 0 0 C 360 to 30 t1.32
7: event end code="M30"
end of program: 7 blocks, 5 motions, 0 errors, 0 warnings

=== about
The shorter way round: 210 is reached by -150, -210 by +150; exactly half a turn goes forward.
proves: nct-5.6-short
=== settings
axis = C 4 rotary carries nothing
N0107.REN.4 = 1
N0107.ASH.4 = 1
=== main
G90 C210
G91 C150
G90 C-210
G91 C-150
G90 C180
G91 C30
M30
=== truth
* * * rotary -150
* * * rotary 0
* * * rotary 150
* * * rotary 0
* * * rotary 180
* * * rotary 210
=== expect
file 0 main.nc
main.nc:1:5: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G90 C210
        ^~~~
1: rapid from 0 0 0 to 0 0 0 C 0 to -150 t0.6
2: rapid to 0 0 0 C -150 to 0 t0.6
3: rapid to 0 0 0 C 0 to 150 t0.6
4: rapid to 0 0 0 C 150 to 0 t0.6
5: rapid to 0 0 0 C 0 to 180 t0.72
6: rapid to 0 0 0 C 180 to 210 t0.12
7: event end code="M30"
end of program: 7 blocks, 6 motions, 0 errors, 0 warnings

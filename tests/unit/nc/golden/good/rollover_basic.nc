=== about
A rotary axis within one turn, basic way: the travel is the remainder of the difference. The manual's table; with
G91 whole turns are cut.
proves: nct-5.6-basic nct-5.6-inc nct-5.6-N0106-1 nct-5.6-N0107 nct-5.6-N0108
=== settings
axis = C 4 rotary carries nothing
N0107.REN.4 = 1
=== main
G90 C210
C0
C570
C0
C930
C0
C-210
C0
C-570
C0
C-930
G91 C30
C390
C-750
G90 C0
M30
=== truth
* * * rotary 210
* * * rotary 0
* * * rotary 210
* * * rotary 0
* * * rotary 210
* * * rotary 0
* * * rotary -210
* * * rotary -360
* * * rotary -570
* * * rotary -720
* * * rotary -930
* * * rotary -900
* * * rotary -870
* * * rotary -900
* * * rotary -1080
=== expect
file 0 main.nc
main.nc:1:5: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G90 C210
        ^~~~
1: rapid from 0 0 0 to 0 0 0 C 0 to 210 t0.84
2: rapid to 0 0 0 C 210 to 0 t0.84
3: rapid to 0 0 0 C 0 to 210 t0.84
4: rapid to 0 0 0 C 210 to 0 t0.84
5: rapid to 0 0 0 C 0 to 210 t0.84
6: rapid to 0 0 0 C 210 to 0 t0.84
7: rapid to 0 0 0 C 0 to -210 t0.84
8: rapid to 0 0 0 C -210 to -360 t0.6
9: rapid to 0 0 0 C -360 to -570 t0.84
10: rapid to 0 0 0 C -570 to -720 t0.6
11: rapid to 0 0 0 C -720 to -930 t0.84
12: rapid to 0 0 0 C -930 to -900 t0.12
13: rapid to 0 0 0 C -900 to -870 t0.12
14: rapid to 0 0 0 C -870 to -900 t0.12
15: rapid to 0 0 0 C -900 to -1080 t0.72
16: event end code="M30"
end of program: 16 blocks, 15 motions, 0 errors, 0 warnings

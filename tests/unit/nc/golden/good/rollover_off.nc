=== about
Without N0107.REN a rotary axis counts on like a linear one; another period than 360 with it; G53 turns the same way.
proves: nct-5.6-inc nct-5.6-N0108 nct-5.6-N0107
=== settings
axis = C 4 rotary carries nothing
axis = B 5 rotary carries nothing
N0107.REN.5 = 1
N0108.5 = 100
=== main
G91 C30
C390
C750
G90 B130
G53 B10
M30
=== truth
* * * rotary 30 0
* * * rotary 420 0
* * * rotary 1170 0
* * * rotary 1170 30
* * * rotary 1170 10
=== expect
file 0 main.nc
main.nc:1:5: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G91 C30
        ^~~
1: rapid from 0 0 0 to 0 0 0 C 0 to 30 B 0 to 0 t0.12
2: rapid to 0 0 0 C 30 to 420 B 0 to 0 t1.56
3: rapid to 0 0 0 C 420 to 1170 B 0 to 0 t3
main.nc:4:5: note[nct-rotary-told]: axis B turns nothing that the job describes: its position is told, the path does not follow it
    G90 B130
        ^~~~
4: rapid to 0 0 0 C 1170 to 1170 B 0 to 30 t0.12
main.nc:5:1: warning[nct-machine-zero]: G53: nothing says where machine zero lies: Z goes to the top of travel, where the tool starts above the stock; a job file tells machine zero by G54 under [offsets.work], which is the workpiece's zero seen from it
    G53 B10
    ^~~~~~~
5: rapid to 0 0 0 C 1170 to 1170 B 30 to 10 t0.08
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 1 warnings

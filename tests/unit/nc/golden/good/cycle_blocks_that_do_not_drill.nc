=== about
proves: nct-18.2-trigger nct-18.2-G04 nct-18.1.5-G81
=== main
G0 Z10 M3 S1000
G81 X10 Z-5 R2 F100
F200
M8
G4 P1
I5 Q3
X20
M30
=== truth
0 0 10
10 0 10
10 0 2
feed 10 0 -5
10 0 10
20 0 10
20 0 2
feed 20 0 -5
20 0 10
=== expect
file 0 main.nc
1: event spindle rpm=1000 direction="cw"
1: rapid from 0 0 0 to 0 0 10 t0.04
2: rapid to 10 0 10 t0.04
2: rapid to 10 0 2 t0.032
2: feed to 10 0 -5 F100 t4.2
2: rapid to 10 0 10 t0.06
4: event coolant code="M8" on=true
5: event dwell seconds=1
main.nc:6:1: warning[nct-unused-word]: I5 does nothing in this block of G81: no hole is named, and words of the cycle without one are not kept
    I5 Q3
    ^~
main.nc:6:4: warning[nct-unused-word]: Q3 does nothing in this block of G81: no hole is named, and words of the cycle without one are not kept
    I5 Q3
       ^~
7: rapid to 20 0 10 t0.04
7: rapid to 20 0 2 t0.032
7: feed to 20 0 -5 F200 t2.1
7: rapid to 20 0 10 t0.06
8: event end code="M30"
end of program: 8 blocks, 9 motions, 0 errors, 2 warnings

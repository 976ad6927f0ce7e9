=== about
G92 S, the least speed N0688, another axis, inches, and feed per turn. 400 m/min at radius 50.5: 1260.6 rpm, 200 allowed.
Feed per turn along X: 100 m/min from radius 100 to 200 takes 2 pi * 100 * 150 / 100000 = 0.9425 min at 1 mm a turn.
Across the middle: with 1000 rpm at most radius 15.9155 is the bound.
proves: nct-11.5.2-G92S nct-11.5.3-G96P nct-11.5.1-G96
=== settings
N0688 = 20
=== main
G92 S200
G0 X50.5
G96 S400 P1 M3
G1 F100 Y10
G0 X10000
G1 Y0
G92 S0
G0 X100
S100
G95 F1
G1 X200
G92 S1000
X-200
G96 P2 S100
G94 F100
Y20
G20 S300
G1 F10 Z1
M30
=== truth
50.5 0 0 S 0
50.5 10 0 S 200
10000 10 0 S 200
10000 0 0 S 20
100 0 0 S 20
200 0 0 F 106.1033 t 56.5487
-200 0 0 t 151.7514
* * *
* * * S 727.6564
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 50.5 0 0 t0.202
3: event spindle rpm=200 direction="cw"
4: feed to 50.5 10 0 F100 t6
5: rapid to 10000 10 0 t39.798
5: event spindle rpm=20 direction="cw"
6: feed to 10000 0 0 F100 t6
8: rapid to 100 0 0 t39.6
8: event spindle rpm=636.6197723675814 direction="cw"
9: event spindle rpm=159.15494309189535 direction="cw"
11: feed to 200 0 0 F106.1033 t56.5487
13: feed to -200 0 0 F158.1534 t151.7514
14: event spindle rpm=1000 direction="cw"
16: feed to -200 20 0 F100 t12
main.nc:17:1: warning[nct-feed-unit]: the unit changes: the modal feed keeps its number and takes the new unit
    G20 S300
    ^~~~~~~~
17: event spindle rpm=727.6563998161455 direction="cw"
18: feed to -200 20 25.4 F254 t6
19: event end code="M30"
end of program: 19 blocks, 9 motions, 0 errors, 1 warnings

=== about
The listings of 8.8, 8.9 and the main spindle of 8.5: S2 follows S1, no faster than both may; S1 becomes C1; M32 makes
S2 the main spindle.
proves: nct-11.7.4-sync nct-11.8-convert nct-11.4-main nct-11.5.1-G96
=== settings
spindle = 1 name S1 axis C1 axis_code 20 main 31 top 4000
spindle = 2 name S2 main 32 sync 21 shift 22 top 2500
axis = C1 6 rotary carries nothing
N0685.2 = 256
=== main
S1=3000 M3
S2=0 M21
G1 X10 F100
S2=1200 M4
M22
S1=0 M20
G28 G91 C1=0
G90
G1 C1=90 F1000
S1=3000 M3
X20
S2=400 M4
M32
X30
G96 S300 M3
X40
M31
X50
M30
=== truth
10 0 0 S 2500
* * * S 0
* * * S 3000
30 0 0 S -400
40 0 0 S 1364.1852
50 0 0 S 1061.033
=== says
spindle rpm=3000 direction="cw" spindle=1
direction="synchronous" spindle=2 to=1
spindle rpm=1200 direction="ccw" spindle=2
direction="axis" spindle=1 axis="C1"
spindle rpm=3000 direction="cw" spindle=1
main_spindle=2
=== expect
file 0 main.nc
1: event spindle rpm=3000 direction="cw" spindle=1
2: event spindle rpm=2500 direction="cw" spindle=1
2: event spindle rpm=2500 direction="synchronous" spindle=2 to=1
3: feed from 0 0 0 to 10 0 0 C1 0 to 0 F100 t6
4: event spindle rpm=1200 direction="ccw" spindle=2
5: event spindle rpm=2500 direction="synchronous" spindle=2 to=1 shift_pulses=256
6: event spindle rpm=0 direction="cw" spindle=1
6: event spindle rpm=0 direction="stop" spindle=1
6: event spindle rpm=0 direction="axis" spindle=1 axis="C1"
main.nc:7:1: warning[nct-reference]: the job does not give reference point 1: the start position is taken; a job file tells it by reference_points under [machine]
    G28 G91 C1=0
    ^~~~~~~~~~~~
main.nc:9:4: note[nct-rotary-told]: axis C1 turns nothing that the job describes: its position is told, the path does not follow it
    G1 C1=90 F1000
       ^~~~~
9: feed to 10 0 0 C1 0 to 90 F1000 t5.4
10: event spindle rpm=3000 direction="cw" spindle=1
11: feed to 20 0 0 C1 90 to 90 F1000 t0.6
12: event spindle rpm=400 direction="ccw" spindle=2
13: event function main_spindle=2
13: event spindle rpm=400 direction="ccw" spindle=2
14: feed to 30 0 0 C1 90 to 90 F1000 t0.6
15: event spindle rpm=1591.5494309189535 direction="cw" spindle=2
16: feed to 40 0 0 C1 90 to 90 F1000 t0.6
17: event function main_spindle=1
17: event spindle rpm=3000 direction="cw" spindle=1
18: feed to 50 0 0 C1 90 to 90 F1000 t0.6
19: event end code="M30"
end of program: 19 blocks, 6 motions, 0 errors, 1 warnings

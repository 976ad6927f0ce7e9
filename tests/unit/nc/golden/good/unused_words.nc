=== about
Words that a block gives and its cycle does not read are told: K where shops mean L, Q of G81, I of a rigid tap without
N1503.EOE, K across the plane of G76, and words of a block without a hole. What another block of the mode may read stays.
proves: nct-18-IJK nct-18-Q
=== settings
D2 = 1
=== main
G17 G0 X0 Y0 Z50 S500 M3 F100
G81 X10 Z-5 R2 K3
G81 X20 Q4 P1 E1
G83 X30
R3 Q5
G82 X40 P0.5 L2
G80
G76 X50 Z-5 R2 I1 J0 K9 P1
G80
G84.2 X60 Z-5 R2 I50 Q3 E1
G80
G18 G81 X70 Y-5 Z0 R2 K1
G80
G17
G41 G0 X80 D1 K4
G40 X90
G31 X99 P2
G2 L3
G2 R5
G0
G40 I1 J0
G17 G41 D2 G1 X120 F100
G41 X130 I1
G39 I1 J-1 K5
Y-30
G40 X150 I1
M30
=== says
K3 does nothing in this block of G81: the cycle does not read K; repeats are programmed with L
Q4 does nothing in this block of G81
P1 does nothing
E1 does nothing
R3 does nothing in this block of G83: no hole
Q5 does nothing
K9 does nothing in this block of G76
I50 does nothing in this block of G84.2
K1 does nothing
K4 does nothing in this block of G41: it stands across the plane
L3 does nothing in this block of G2
R5 does nothing in this block of G2: the arc ends where it starts; a full circle needs I, J or K
I1 does nothing in this block of G40: cutter compensation neither starts nor ends here
J0 does nothing
I1 does nothing in this block of G41: cutter compensation neither starts nor ends here
K5 does nothing in this block of G39: it stands across the plane
=== expect
file 0 main.nc
1: event spindle rpm=500 direction="cw"
1: rapid from 0 0 0 to 0 0 50 t0.2
main.nc:2:16: warning[nct-unused-word]: K3 does nothing in this block of G81: the cycle does not read K; repeats are programmed with L
    G81 X10 Z-5 R2 K3
                   ^~
2: rapid to 10 0 50 t0.04
2: rapid to 10 0 2 t0.192
2: feed to 10 0 -5 F100 t4.2
2: rapid to 10 0 50 t0.22
main.nc:3:9: warning[nct-unused-word]: Q4 does nothing in this block of G81: the cycle does not read it; another one may, until G80
    G81 X20 Q4 P1 E1
            ^~
main.nc:3:12: warning[nct-unused-word]: P1 does nothing in this block of G81: the cycle does not read it; another one may, until G80
    G81 X20 Q4 P1 E1
               ^~
main.nc:3:15: warning[nct-unused-word]: E1 does nothing in this block of G81: the cycle does not read it; another one may, until G80
    G81 X20 Q4 P1 E1
                  ^~
3: rapid to 20 0 50 t0.04
3: rapid to 20 0 2 t0.192
3: feed to 20 0 -5 F100 t4.2
3: rapid to 20 0 50 t0.22
4: rapid to 30 0 50 t0.04
4: rapid to 30 0 2 t0.192
4: feed to 30 0 -2 F100 t2.4
4: rapid to 30 0 2 t0.016
4: rapid to 30 0 -1 t0.012
4: feed to 30 0 -5 F100 t2.4
4: rapid to 30 0 50 t0.22
main.nc:5:1: warning[nct-unused-word]: R3 does nothing in this block of G83: no hole is named, and words of the cycle without one are not kept
    R3 Q5
    ^~
main.nc:5:4: warning[nct-unused-word]: Q5 does nothing in this block of G83: no hole is named, and words of the cycle without one are not kept
    R3 Q5
       ^~
6: rapid to 40 0 50 t0.04
6: rapid to 40 0 2 t0.192
6: feed to 40 0 -5 F100 t4.2
6: event dwell seconds=0.5
6: rapid to 40 0 50 t0.22
6: rapid to 40 0 2 t0.192
6: feed to 40 0 -5 F100 t4.2
6: event dwell seconds=0.5
6: rapid to 40 0 50 t0.22
main.nc:8:22: warning[nct-unused-word]: K9 does nothing in this block of G76: the cycle does not read K; repeats are programmed with L
    G76 X50 Z-5 R2 I1 J0 K9 P1
                         ^~
8: rapid to 50 0 50 t0.04
8: rapid to 50 0 2 t0.192
8: feed to 50 0 -5 F100 t4.2
8: event dwell seconds=1
8: event spindle rpm=0 direction="oriented"
8: rapid to 51 0 -5 t0.004
8: rapid to 51 0 50 t0.22
8: rapid to 50 0 50 t0.004
8: event spindle rpm=500 direction="cw"
main.nc:10:18: warning[nct-unused-word]: I50 does nothing in this block of G84.2: the cycle does not read it; another one may, until G80
    G84.2 X60 Z-5 R2 I50 Q3 E1
                     ^~~
10: rapid to 60 0 50 t0.04
10: rapid to 60 0 2 t0.192
10: event spindle rpm=0 direction="position loop"
10: thread to 60 0 -1 F100 t1.8
10: thread to 60 0 0 F100 t0.6
10: thread to 60 0 -4 F100 t2.4
10: thread to 60 0 -3 F100 t0.6
10: thread to 60 0 -5 F100 t1.2
10: thread to 60 0 2 F100 t4.2
10: rapid to 60 0 50 t0.192
main.nc:12:23: warning[nct-unused-word]: K1 does nothing in this block of G81: the cycle does not read K; repeats are programmed with L
    G18 G81 X70 Y-5 Z0 R2 K1
                          ^~
12: rapid to 70 0 0 t0.2
12: rapid to 70 2 0 t0.008
12: feed to 70 -5 0 F100 t4.2
12: rapid to 70 0 0 t0.02
main.nc:15:12: warning[nct-offset-missing]: D1 has no value in the offset table: 0 is taken (--offset D1=VALUE)
    G41 G0 X80 D1 K4
               ^~
main.nc:15:15: warning[nct-unused-word]: K4 does nothing in this block of G41: it stands across the plane
    G41 G0 X80 D1 K4
                  ^~
15: rapid to 80 0 0 t0.04
16: rapid to 90 0 0 t0.04
main.nc:17:1: warning[nct-no-probe]: there is no stock here that a measuring move could touch: it goes to its end
    G31 X99 P2
    ^~~~~~~~~~
17: probe to 99 0 0 F100 t5.4
17: event probe contact=false
main.nc:18:4: warning[nct-unused-word]: L3 does nothing in this block of G2: the code does not read it here
    G2 L3
       ^~
main.nc:19:4: warning[nct-unused-word]: R5 does nothing in this block of G2: the arc ends where it starts; a full circle needs I, J or K
    G2 R5
       ^~
main.nc:21:5: warning[nct-unused-word]: I1 does nothing in this block of G40: cutter compensation neither starts nor ends here
    G40 I1 J0
        ^~
main.nc:21:8: warning[nct-unused-word]: J0 does nothing in this block of G40: cutter compensation neither starts nor ends here
    G40 I1 J0
           ^~
main.nc:23:10: warning[nct-unused-word]: I1 does nothing in this block of G41: cutter compensation neither starts nor ends here
    G41 X130 I1
             ^~
main.nc:24:12: warning[nct-unused-word]: K5 does nothing in this block of G39: it stands across the plane
    G39 I1 J-1 K5
               ^~
22: feed to 120 1 0 F100 t12.6143
23: feed to 130 1 0 F100 t6
24: feed arc to 130.7071 0.7071 0 center 130 0 0 normal 0 0 1 sweep -45 F100 t0.4712
25: feed to 131 -29 0 F100 t17.8251
26: feed to 150 -30 0 F100 t11.4158
27: event end code="M30"
end of program: 27 blocks, 50 motions, 0 errors, 18 warnings

=== about
proves: nct-18.2-M nct-18-hole nct-18.1.6-G82 nct-18.1.4-G80 nct-18.1.11-G85 nct-3-G80 nct-3-G81 nct-3-G82
=== main
N1 G17 G0 Z10 M3 S1000
N2 G81 X10 Y10 Z-5 R2 F100
N3 X20
N4 G82 Y20 Z-6 P1
N5 G80 M5
N6 G85 Y30 Z-7 R1 P2 M3
N7 G0 X0
M30
=== truth
0 0 10
10 10 10
10 10 2
10 10 -5
10 10 10
20 10 10
20 10 2
20 10 -5
20 10 10
20 20 10
20 20 2
20 20 -6
20 20 10
20 30 10
20 30 1
feed 20 30 -7
feed 20 30 1
rapid 20 30 10
0 30 10
=== expect
file 0 main.nc
1 N1: event spindle rpm=1000 direction="cw"
1 N1: rapid from 0 0 0 to 0 0 10 t0.04
2 N2: rapid to 10 10 10 t0.04
2 N2: rapid to 10 10 2 t0.032
2 N2: feed to 10 10 -5 F100 t4.2
2 N2: rapid to 10 10 10 t0.06
3 N3: rapid to 20 10 10 t0.04
3 N3: rapid to 20 10 2 t0.032
3 N3: feed to 20 10 -5 F100 t4.2
3 N3: rapid to 20 10 10 t0.06
4 N4: rapid to 20 20 10 t0.04
4 N4: rapid to 20 20 2 t0.032
4 N4: feed to 20 20 -6 F100 t4.8
4 N4: event dwell seconds=1
4 N4: rapid to 20 20 10 t0.064
5 N5: event spindle rpm=0 direction="stop"
main.nc:6:19: warning[nct-unused-word]: P2 does nothing in this block of G85: the cycle does not read it; another one may, until G80
    N6 G85 Y30 Z-7 R1 P2 M3
                      ^~
6 N6: rapid to 20 30 10 t0.04
6 N6: event spindle rpm=1000 direction="cw"
6 N6: rapid to 20 30 1 t0.036
6 N6: feed to 20 30 -7 F100 t4.8
6 N6: feed to 20 30 1 F100 t4.8
6 N6: rapid to 20 30 10 t0.036
7 N7: rapid to 0 30 10 t0.08
8: event end code="M30"
end of program: 8 blocks, 19 motions, 0 errors, 1 warnings

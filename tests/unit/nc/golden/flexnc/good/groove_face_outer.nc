=== about
The same with the outer edge as the point: two millimetres further out.
proves: fnc-3.6-G79.2
=== settings
control = flexnc
start = 100 0 50
param.ring_edge = 1
=== main
T1M06D1
S300M03
G98F100
G79.2X80A60Z5P1B2V0H2Q0.8
M02
=== truth
32 0 2
32 0 -1
32 0 2
33.6 0 2
33.6 0 -1
33.6 0 2
35.2 0 2
35.2 0 -1
35.2 0 2
36.8 0 2
36.8 0 -1
36.8 0 2
38.4 0 2
38.4 0 -1
38.4 0 2
40 0 2
40 0 -1
40 0 2
32 0 2
32 0 -2
32 0 2
33.6 0 2
33.6 0 -2
33.6 0 2
35.2 0 2
35.2 0 -2
35.2 0 2
36.8 0 2
36.8 0 -2
36.8 0 2
38.4 0 2
38.4 0 -2
38.4 0 2
40 0 2
40 0 -2
40 0 2
32 0 2
32 0 -3
32 0 2
33.6 0 2
33.6 0 -3
33.6 0 2
35.2 0 2
35.2 0 -3
35.2 0 2
36.8 0 2
36.8 0 -3
36.8 0 2
38.4 0 2
38.4 0 -3
38.4 0 2
40 0 2
40 0 -3
40 0 2
32 0 2
32 0 -4
32 0 2
33.6 0 2
33.6 0 -4
33.6 0 2
35.2 0 2
35.2 0 -4
35.2 0 2
36.8 0 2
36.8 0 -4
36.8 0 2
38.4 0 2
38.4 0 -4
38.4 0 2
40 0 2
40 0 -4
40 0 2
32 0 2
32 0 -5
32 0 2
33.6 0 2
33.6 0 -5
33.6 0 2
35.2 0 2
35.2 0 -5
35.2 0 2
36.8 0 2
36.8 0 -5
36.8 0 2
38.4 0 2
38.4 0 -5
38.4 0 2
40 0 2
40 0 -5
40 0 2
32 0 2
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G79.2 of line 4
1/1 depth 1: rapid from 100 0 50 to 32 0 2 t0.272
1/2 depth 1: feed to 32 0 -1 F100 t1.8
1/3 depth 1: rapid to 32 0 2 t0.012
1/4 depth 1: rapid to 33.6 0 2 t0.0064
1/5 depth 1: feed to 33.6 0 -1 F100 t1.8
1/6 depth 1: rapid to 33.6 0 2 t0.012
1/7 depth 1: rapid to 35.2 0 2 t0.0064
1/8 depth 1: feed to 35.2 0 -1 F100 t1.8
1/9 depth 1: rapid to 35.2 0 2 t0.012
1/10 depth 1: rapid to 36.8 0 2 t0.0064
1/11 depth 1: feed to 36.8 0 -1 F100 t1.8
1/12 depth 1: rapid to 36.8 0 2 t0.012
1/13 depth 1: rapid to 38.4 0 2 t0.0064
1/14 depth 1: feed to 38.4 0 -1 F100 t1.8
1/15 depth 1: rapid to 38.4 0 2 t0.012
1/16 depth 1: rapid to 40 0 2 t0.0064
1/17 depth 1: feed to 40 0 -1 F100 t1.8
1/18 depth 1: rapid to 40 0 2 t0.012
1/19 depth 1: rapid to 32 0 2 t0.032
1/20 depth 1: feed to 32 0 -2 F100 t2.4
1/21 depth 1: rapid to 32 0 2 t0.016
1/22 depth 1: rapid to 33.6 0 2 t0.0064
1/23 depth 1: feed to 33.6 0 -2 F100 t2.4
1/24 depth 1: rapid to 33.6 0 2 t0.016
1/25 depth 1: rapid to 35.2 0 2 t0.0064
1/26 depth 1: feed to 35.2 0 -2 F100 t2.4
1/27 depth 1: rapid to 35.2 0 2 t0.016
1/28 depth 1: rapid to 36.8 0 2 t0.0064
1/29 depth 1: feed to 36.8 0 -2 F100 t2.4
1/30 depth 1: rapid to 36.8 0 2 t0.016
1/31 depth 1: rapid to 38.4 0 2 t0.0064
1/32 depth 1: feed to 38.4 0 -2 F100 t2.4
1/33 depth 1: rapid to 38.4 0 2 t0.016
1/34 depth 1: rapid to 40 0 2 t0.0064
1/35 depth 1: feed to 40 0 -2 F100 t2.4
1/36 depth 1: rapid to 40 0 2 t0.016
1/37 depth 1: rapid to 32 0 2 t0.032
1/38 depth 1: feed to 32 0 -3 F100 t3
1/39 depth 1: rapid to 32 0 2 t0.02
1/40 depth 1: rapid to 33.6 0 2 t0.0064
1/41 depth 1: feed to 33.6 0 -3 F100 t3
1/42 depth 1: rapid to 33.6 0 2 t0.02
1/43 depth 1: rapid to 35.2 0 2 t0.0064
1/44 depth 1: feed to 35.2 0 -3 F100 t3
1/45 depth 1: rapid to 35.2 0 2 t0.02
1/46 depth 1: rapid to 36.8 0 2 t0.0064
1/47 depth 1: feed to 36.8 0 -3 F100 t3
1/48 depth 1: rapid to 36.8 0 2 t0.02
1/49 depth 1: rapid to 38.4 0 2 t0.0064
1/50 depth 1: feed to 38.4 0 -3 F100 t3
1/51 depth 1: rapid to 38.4 0 2 t0.02
1/52 depth 1: rapid to 40 0 2 t0.0064
1/53 depth 1: feed to 40 0 -3 F100 t3
1/54 depth 1: rapid to 40 0 2 t0.02
1/55 depth 1: rapid to 32 0 2 t0.032
1/56 depth 1: feed to 32 0 -4 F100 t3.6
1/57 depth 1: rapid to 32 0 2 t0.024
1/58 depth 1: rapid to 33.6 0 2 t0.0064
1/59 depth 1: feed to 33.6 0 -4 F100 t3.6
1/60 depth 1: rapid to 33.6 0 2 t0.024
1/61 depth 1: rapid to 35.2 0 2 t0.0064
1/62 depth 1: feed to 35.2 0 -4 F100 t3.6
1/63 depth 1: rapid to 35.2 0 2 t0.024
1/64 depth 1: rapid to 36.8 0 2 t0.0064
1/65 depth 1: feed to 36.8 0 -4 F100 t3.6
1/66 depth 1: rapid to 36.8 0 2 t0.024
1/67 depth 1: rapid to 38.4 0 2 t0.0064
1/68 depth 1: feed to 38.4 0 -4 F100 t3.6
1/69 depth 1: rapid to 38.4 0 2 t0.024
1/70 depth 1: rapid to 40 0 2 t0.0064
1/71 depth 1: feed to 40 0 -4 F100 t3.6
1/72 depth 1: rapid to 40 0 2 t0.024
1/73 depth 1: rapid to 32 0 2 t0.032
1/74 depth 1: feed to 32 0 -5 F100 t4.2
1/75 depth 1: rapid to 32 0 2 t0.028
1/76 depth 1: rapid to 33.6 0 2 t0.0064
1/77 depth 1: feed to 33.6 0 -5 F100 t4.2
1/78 depth 1: rapid to 33.6 0 2 t0.028
1/79 depth 1: rapid to 35.2 0 2 t0.0064
1/80 depth 1: feed to 35.2 0 -5 F100 t4.2
1/81 depth 1: rapid to 35.2 0 2 t0.028
1/82 depth 1: rapid to 36.8 0 2 t0.0064
1/83 depth 1: feed to 36.8 0 -5 F100 t4.2
1/84 depth 1: rapid to 36.8 0 2 t0.028
1/85 depth 1: rapid to 38.4 0 2 t0.0064
1/86 depth 1: feed to 38.4 0 -5 F100 t4.2
1/87 depth 1: rapid to 38.4 0 2 t0.028
1/88 depth 1: rapid to 40 0 2 t0.0064
1/89 depth 1: feed to 40 0 -5 F100 t4.2
1/90 depth 1: rapid to 40 0 2 t0.028
1/91 depth 1: rapid to 32 0 2 t0.032
5: event spindle rpm=0 direction="stop"
5: event end code="M02"
end of program: 5 blocks, 91 motions, 0 errors, 0 warnings

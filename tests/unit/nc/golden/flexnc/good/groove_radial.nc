=== about
The manual's groove: five layers of five plunges.
proves: fnc-3.6-G79.1
=== settings
control = flexnc
start = 100 0 50
=== main
T1M06D1
S300M03
G98F100
G79.1X50A40H2P1C2Y8V13Q0.75
M02
=== truth
27 0 -15
24 0 -15
27 0 -15
27 0 -16.5
24 0 -16.5
27 0 -16.5
27 0 -18
24 0 -18
27 0 -18
27 0 -19.5
24 0 -19.5
27 0 -19.5
27 0 -21
24 0 -21
27 0 -21
27 0 -15
23 0 -15
27 0 -15
27 0 -16.5
23 0 -16.5
27 0 -16.5
27 0 -18
23 0 -18
27 0 -18
27 0 -19.5
23 0 -19.5
27 0 -19.5
27 0 -21
23 0 -21
27 0 -21
27 0 -15
22 0 -15
27 0 -15
27 0 -16.5
22 0 -16.5
27 0 -16.5
27 0 -18
22 0 -18
27 0 -18
27 0 -19.5
22 0 -19.5
27 0 -19.5
27 0 -21
22 0 -21
27 0 -21
27 0 -15
21 0 -15
27 0 -15
27 0 -16.5
21 0 -16.5
27 0 -16.5
27 0 -18
21 0 -18
27 0 -18
27 0 -19.5
21 0 -19.5
27 0 -19.5
27 0 -21
21 0 -21
27 0 -21
27 0 -15
20 0 -15
27 0 -15
27 0 -16.5
20 0 -16.5
27 0 -16.5
27 0 -18
20 0 -18
27 0 -18
27 0 -19.5
20 0 -19.5
27 0 -19.5
27 0 -21
20 0 -21
27 0 -21
27 0 -15
=== expect
file 0 main.nc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
file 1 G79.1 of line 4
1/1 depth 1: rapid from 100 0 50 to 27 0 -15 t0.292
1/2 depth 1: feed to 24 0 -15 F100 t1.8
1/3 depth 1: rapid to 27 0 -15 t0.012
1/4 depth 1: rapid to 27 0 -16.5 t0.006
1/5 depth 1: feed to 24 0 -16.5 F100 t1.8
1/6 depth 1: rapid to 27 0 -16.5 t0.012
1/7 depth 1: rapid to 27 0 -18 t0.006
1/8 depth 1: feed to 24 0 -18 F100 t1.8
1/9 depth 1: rapid to 27 0 -18 t0.012
1/10 depth 1: rapid to 27 0 -19.5 t0.006
1/11 depth 1: feed to 24 0 -19.5 F100 t1.8
1/12 depth 1: rapid to 27 0 -19.5 t0.012
1/13 depth 1: rapid to 27 0 -21 t0.006
1/14 depth 1: feed to 24 0 -21 F100 t1.8
1/15 depth 1: rapid to 27 0 -21 t0.012
1/16 depth 1: rapid to 27 0 -15 t0.024
1/17 depth 1: feed to 23 0 -15 F100 t2.4
1/18 depth 1: rapid to 27 0 -15 t0.016
1/19 depth 1: rapid to 27 0 -16.5 t0.006
1/20 depth 1: feed to 23 0 -16.5 F100 t2.4
1/21 depth 1: rapid to 27 0 -16.5 t0.016
1/22 depth 1: rapid to 27 0 -18 t0.006
1/23 depth 1: feed to 23 0 -18 F100 t2.4
1/24 depth 1: rapid to 27 0 -18 t0.016
1/25 depth 1: rapid to 27 0 -19.5 t0.006
1/26 depth 1: feed to 23 0 -19.5 F100 t2.4
1/27 depth 1: rapid to 27 0 -19.5 t0.016
1/28 depth 1: rapid to 27 0 -21 t0.006
1/29 depth 1: feed to 23 0 -21 F100 t2.4
1/30 depth 1: rapid to 27 0 -21 t0.016
1/31 depth 1: rapid to 27 0 -15 t0.024
1/32 depth 1: feed to 22 0 -15 F100 t3
1/33 depth 1: rapid to 27 0 -15 t0.02
1/34 depth 1: rapid to 27 0 -16.5 t0.006
1/35 depth 1: feed to 22 0 -16.5 F100 t3
1/36 depth 1: rapid to 27 0 -16.5 t0.02
1/37 depth 1: rapid to 27 0 -18 t0.006
1/38 depth 1: feed to 22 0 -18 F100 t3
1/39 depth 1: rapid to 27 0 -18 t0.02
1/40 depth 1: rapid to 27 0 -19.5 t0.006
1/41 depth 1: feed to 22 0 -19.5 F100 t3
1/42 depth 1: rapid to 27 0 -19.5 t0.02
1/43 depth 1: rapid to 27 0 -21 t0.006
1/44 depth 1: feed to 22 0 -21 F100 t3
1/45 depth 1: rapid to 27 0 -21 t0.02
1/46 depth 1: rapid to 27 0 -15 t0.024
1/47 depth 1: feed to 21 0 -15 F100 t3.6
1/48 depth 1: rapid to 27 0 -15 t0.024
1/49 depth 1: rapid to 27 0 -16.5 t0.006
1/50 depth 1: feed to 21 0 -16.5 F100 t3.6
1/51 depth 1: rapid to 27 0 -16.5 t0.024
1/52 depth 1: rapid to 27 0 -18 t0.006
1/53 depth 1: feed to 21 0 -18 F100 t3.6
1/54 depth 1: rapid to 27 0 -18 t0.024
1/55 depth 1: rapid to 27 0 -19.5 t0.006
1/56 depth 1: feed to 21 0 -19.5 F100 t3.6
1/57 depth 1: rapid to 27 0 -19.5 t0.024
1/58 depth 1: rapid to 27 0 -21 t0.006
1/59 depth 1: feed to 21 0 -21 F100 t3.6
1/60 depth 1: rapid to 27 0 -21 t0.024
1/61 depth 1: rapid to 27 0 -15 t0.024
1/62 depth 1: feed to 20 0 -15 F100 t4.2
1/63 depth 1: rapid to 27 0 -15 t0.028
1/64 depth 1: rapid to 27 0 -16.5 t0.006
1/65 depth 1: feed to 20 0 -16.5 F100 t4.2
1/66 depth 1: rapid to 27 0 -16.5 t0.028
1/67 depth 1: rapid to 27 0 -18 t0.006
1/68 depth 1: feed to 20 0 -18 F100 t4.2
1/69 depth 1: rapid to 27 0 -18 t0.028
1/70 depth 1: rapid to 27 0 -19.5 t0.006
1/71 depth 1: feed to 20 0 -19.5 F100 t4.2
1/72 depth 1: rapid to 27 0 -19.5 t0.028
1/73 depth 1: rapid to 27 0 -21 t0.006
1/74 depth 1: feed to 20 0 -21 F100 t4.2
1/75 depth 1: rapid to 27 0 -21 t0.028
1/76 depth 1: rapid to 27 0 -15 t0.024
5: event spindle rpm=0 direction="stop"
5: event end code="M02"
end of program: 5 blocks, 76 motions, 0 errors, 0 warnings

=== about
What the manual's template lines are with C = 50, B = 16 and D = 100 d1 = 25 Z = 10 Z1 = 15 P = 2 C = 2 B = 3 V = 0, as
a saved program text.
proves: fnc-4.5-pmc fnc-4.2-param
=== settings
control = flexnc
start = 100 0 50
main_name = part.pmc
=== main
T1M06D1
S300M03
G98F100
G00X(50/2)Z16
G77X100A25Y10Z15P2C2B3V0
M02
=== truth
25 0 16
52 0 3
48 0 3
48 0 -24.466667
48.4 0 -24.466667
48.4 0 3
46 0 3
46 0 -23.933333
46.4 0 -23.933333
46.4 0 3
44 0 3
44 0 -23.4
44.4 0 -23.4
44.4 0 3
42 0 3
42 0 -22.866667
42.4 0 -22.866667
42.4 0 3
40 0 3
40 0 -22.333333
40.4 0 -22.333333
40.4 0 3
38 0 3
38 0 -21.8
38.4 0 -21.8
38.4 0 3
36 0 3
36 0 -21.266667
36.4 0 -21.266667
36.4 0 3
34 0 3
34 0 -20.733333
34.4 0 -20.733333
34.4 0 3
32 0 3
32 0 -20.2
32.4 0 -20.2
32.4 0 3
30 0 3
30 0 -19.666667
30.4 0 -19.666667
30.4 0 3
28 0 3
28 0 -19.133333
28.4 0 -19.133333
28.4 0 3
26 0 3
26 0 -18.6
26.4 0 -18.6
26.4 0 3
24 0 3
24 0 -18.066667
24.4 0 -18.066667
24.4 0 3
22 0 3
22 0 -17.533333
22.4 0 -17.533333
22.4 0 3
20 0 3
20 0 -17
20.4 0 -17
20.4 0 3
18 0 3
18 0 -16.466667
18.4 0 -16.466667
18.4 0 3
16 0 3
16 0 -15.933333
16.4 0 -15.933333
16.4 0 3
14 0 3
14 0 -15.4
14.4 0 -15.4
14.4 0 3
12.5 0 3
12.5 0 -15
50 0 -25
52 0 -25
52 0 3
=== expect
file 0 part.pmc
1: event tool tool=1
2: event spindle rpm=300 direction="cw"
part.pmc:4:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G00X(50/2)Z16
    ^~~~~~~~~~~~~
4: rapid from 100 0 50 to 25 0 16 t0.3
file 1 G77 of line 5
1/1 depth 1: rapid to 52 0 3 t0.108
1/2 depth 1: feed to 48 0 3 F100 t2.4
1/3 depth 1: feed to 48 0 -24.4667 F100 t16.48
1/4 depth 1: feed to 48.4 0 -24.4667 F100 t0.24
1/5 depth 1: rapid to 48.4 0 3 t0.1099
1/6 depth 1: feed to 46 0 3 F100 t1.44
1/7 depth 1: feed to 46 0 -23.9333 F100 t16.16
1/8 depth 1: feed to 46.4 0 -23.9333 F100 t0.24
1/9 depth 1: rapid to 46.4 0 3 t0.1077
1/10 depth 1: feed to 44 0 3 F100 t1.44
1/11 depth 1: feed to 44 0 -23.4 F100 t15.84
1/12 depth 1: feed to 44.4 0 -23.4 F100 t0.24
1/13 depth 1: rapid to 44.4 0 3 t0.1056
1/14 depth 1: feed to 42 0 3 F100 t1.44
1/15 depth 1: feed to 42 0 -22.8667 F100 t15.52
1/16 depth 1: feed to 42.4 0 -22.8667 F100 t0.24
1/17 depth 1: rapid to 42.4 0 3 t0.1035
1/18 depth 1: feed to 40 0 3 F100 t1.44
1/19 depth 1: feed to 40 0 -22.3333 F100 t15.2
1/20 depth 1: feed to 40.4 0 -22.3333 F100 t0.24
1/21 depth 1: rapid to 40.4 0 3 t0.1013
1/22 depth 1: feed to 38 0 3 F100 t1.44
1/23 depth 1: feed to 38 0 -21.8 F100 t14.88
1/24 depth 1: feed to 38.4 0 -21.8 F100 t0.24
1/25 depth 1: rapid to 38.4 0 3 t0.0992
1/26 depth 1: feed to 36 0 3 F100 t1.44
1/27 depth 1: feed to 36 0 -21.2667 F100 t14.56
1/28 depth 1: feed to 36.4 0 -21.2667 F100 t0.24
1/29 depth 1: rapid to 36.4 0 3 t0.0971
1/30 depth 1: feed to 34 0 3 F100 t1.44
1/31 depth 1: feed to 34 0 -20.7333 F100 t14.24
1/32 depth 1: feed to 34.4 0 -20.7333 F100 t0.24
1/33 depth 1: rapid to 34.4 0 3 t0.0949
1/34 depth 1: feed to 32 0 3 F100 t1.44
1/35 depth 1: feed to 32 0 -20.2 F100 t13.92
1/36 depth 1: feed to 32.4 0 -20.2 F100 t0.24
1/37 depth 1: rapid to 32.4 0 3 t0.0928
1/38 depth 1: feed to 30 0 3 F100 t1.44
1/39 depth 1: feed to 30 0 -19.6667 F100 t13.6
1/40 depth 1: feed to 30.4 0 -19.6667 F100 t0.24
1/41 depth 1: rapid to 30.4 0 3 t0.0907
1/42 depth 1: feed to 28 0 3 F100 t1.44
1/43 depth 1: feed to 28 0 -19.1333 F100 t13.28
1/44 depth 1: feed to 28.4 0 -19.1333 F100 t0.24
1/45 depth 1: rapid to 28.4 0 3 t0.0885
1/46 depth 1: feed to 26 0 3 F100 t1.44
1/47 depth 1: feed to 26 0 -18.6 F100 t12.96
1/48 depth 1: feed to 26.4 0 -18.6 F100 t0.24
1/49 depth 1: rapid to 26.4 0 3 t0.0864
1/50 depth 1: feed to 24 0 3 F100 t1.44
1/51 depth 1: feed to 24 0 -18.0667 F100 t12.64
1/52 depth 1: feed to 24.4 0 -18.0667 F100 t0.24
1/53 depth 1: rapid to 24.4 0 3 t0.0843
1/54 depth 1: feed to 22 0 3 F100 t1.44
1/55 depth 1: feed to 22 0 -17.5333 F100 t12.32
1/56 depth 1: feed to 22.4 0 -17.5333 F100 t0.24
1/57 depth 1: rapid to 22.4 0 3 t0.0821
1/58 depth 1: feed to 20 0 3 F100 t1.44
1/59 depth 1: feed to 20 0 -17 F100 t12
1/60 depth 1: feed to 20.4 0 -17 F100 t0.24
1/61 depth 1: rapid to 20.4 0 3 t0.08
1/62 depth 1: feed to 18 0 3 F100 t1.44
1/63 depth 1: feed to 18 0 -16.4667 F100 t11.68
1/64 depth 1: feed to 18.4 0 -16.4667 F100 t0.24
1/65 depth 1: rapid to 18.4 0 3 t0.0779
1/66 depth 1: feed to 16 0 3 F100 t1.44
1/67 depth 1: feed to 16 0 -15.9333 F100 t11.36
1/68 depth 1: feed to 16.4 0 -15.9333 F100 t0.24
1/69 depth 1: rapid to 16.4 0 3 t0.0757
1/70 depth 1: feed to 14 0 3 F100 t1.44
1/71 depth 1: feed to 14 0 -15.4 F100 t11.04
1/72 depth 1: feed to 14.4 0 -15.4 F100 t0.24
1/73 depth 1: rapid to 14.4 0 3 t0.0736
1/74 depth 1: feed to 12.5 0 3 F100 t1.14
1/75 depth 1: feed to 12.5 0 -15 F100 t10.8
1/76 depth 1: feed to 50 0 -25 F100 t23.2863
1/77 depth 1: rapid to 52 0 -25 t0.008
1/78 depth 1: rapid to 52 0 3 t0.112
6: event spindle rpm=0 direction="stop"
6: event end code="M02"
end of program: 6 blocks, 79 motions, 0 errors, 0 warnings

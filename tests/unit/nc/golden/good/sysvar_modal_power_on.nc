=== about
Modal codes after power-on by group, and codes with a decimal point: the digit stands in front. Groups without codes
read 0.
proves: nct-23.1.14-#4001 nct-23.1.14-#4201
=== settings
reference1 = 0 0 0
=== main
G0 X#4007 Y#4009 Z#4010
X#4011 Y#4012 Z#4013
X#4014 Y#4015 Z#4016
X#4017 Y#4021 Z#4022
X#4018 Y#4034 Z#4001
X#4002 Y#4003 Z#4005
X#4006 Y#4008 Z#4004
X#4019 Y#4031 Z#4039
G54.1 P7
G1 G18 F100
X#4014 Y#4001 Z#4002
G53 X#4214 Y#4201 Z0
G53 X#_BUFG[14] Y#_ACTG[1] Z#_ACTG[2]
M30
=== truth
40 80 98
50 67 97
54 64 69
15 113 150
169 880 0
17 90 94
21 49 23
0 0 0
154 1 18
154 1 0
154 1 18
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 40 80 98 t0.392
2: rapid to 50 67 97 t0.052
3: rapid to 54 64 69 t0.112
4: rapid to 15 113 150 t0.324
5: rapid to 169 880 0 t3.068
6: rapid to 17 90 94 t3.16
7: rapid to 21 49 23 t0.284
8: rapid to 0 0 0 t0.196
main.nc:9:1: warning[nct-offset-missing]: G54.1 P7 has no value in the job: 0 is taken (--offset G54.1P7=X,Y,Z)
    G54.1 P7
    ^~~~~~~~
11: feed to 154 1 18 F100 t93.031
12: rapid to 154 1 0 t0.072
13: rapid to 154 1 18 t0.072
14: event end code="M30"
end of program: 14 blocks, 11 motions, 0 errors, 1 warnings

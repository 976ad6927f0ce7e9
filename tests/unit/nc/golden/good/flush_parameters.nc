=== about
Functions that parameters set to end look-ahead (BUF): M90 alone, M70 to M75, S, T and the auxiliary function B. The
compensation vector (5 mm, left of Y+) goes at the end of the block before and comes back with the next motion.
M77 and M8 are not in the set: the contour goes on.
proves: nct-13.3-flush nct-15.5.2-flush
=== settings
D1 = 5
BUF.M1 = 90
BUF.LOW1 = 70
BUF.HIGH1 = 75
BUF.A1 = 1
BUF.S = 1
BUF.T = 1
N1333 = 66
=== main
G41 D1 G1 X50 F600
Y10
M90
Y20
M77
Y30
M72
Y40
S500
Y50
T3
Y60
B7
Y70
M8
Y80
G40 X0
M30
=== truth
45 0 0
50 10 0
45 20 0
50 30 0
50 40 0
50 50 0
50 60 0
45 70 0
45 80 0
0 80 0
=== expect
file 0 main.nc
main.nc:3:1: warning[nct-m-function]: M90 is a function of the machine builder: it has no effect in the simulation
    M90
    ^~~
1: feed from 0 0 0 to 45 0 0 F600 t4.5
2: feed to 50 10 0 F600 t1.118
3: event function code="M90"
main.nc:5:1: warning[nct-m-function]: M77 is a function of the machine builder: it has no effect in the simulation
    M77
    ^~~
main.nc:7:1: warning[nct-m-function]: M72 is a function of the machine builder: it has no effect in the simulation
    M72
    ^~~
4: feed to 45 20 0 F600 t1.118
5: event function code="M77"
6: feed to 50 30 0 F600 t1.118
7: event function code="M72"
8: feed to 50 40 0 F600 t1
10: feed to 50 50 0 F600 t1
12: feed to 50 60 0 F600 t1
13: event function code="B7"
14: feed to 45 70 0 F600 t1.118
15: event coolant code="M8" on=true
16: feed to 45 80 0 F600 t1
17: feed to 0 80 0 F600 t4.5
18: event end code="M30"
end of program: 18 blocks, 10 motions, 0 errors, 3 warnings

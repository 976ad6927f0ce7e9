=== about
The same functions without the parameters: none ends look-ahead.
proves: nct-13.3-flush
=== settings
D1 = 5
N1333 = 66
=== main
G41 D1 G1 X50 F600
Y10
M90
Y20
S500
Y30
T3
Y40
B7
Y50
G40 X0
M30
=== truth
45 0 0
45 10 0
45 20 0
45 30 0
45 40 0
45 50 0
0 50 0
=== expect
file 0 main.nc
main.nc:3:1: warning[nct-m-function]: M90 is a function of the machine builder: it has no effect in the simulation
    M90
    ^~~
1: feed from 0 0 0 to 45 0 0 F600 t4.5
2: feed to 45 10 0 F600 t1
3: event function code="M90"
4: feed to 45 20 0 F600 t1
6: feed to 45 30 0 F600 t1
8: feed to 45 40 0 F600 t1
9: event function code="B7"
10: feed to 45 50 0 F600 t1
11: feed to 0 50 0 F600 t4.5
12: event end code="M30"
end of program: 12 blocks, 7 motions, 0 errors, 1 warnings

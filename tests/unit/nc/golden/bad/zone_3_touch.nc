=== about
Zone 3 is entered where its border is touched.
proves: nct-22.3-zone3
=== settings
N1000.RE3.1 = 1
N1000.RE3.2 = 1
N1008.1 = 50
N1009.1 = 20
N1008.2 = 10
N1009.2 = -10
=== main
G0 Y10.001
X100
X0
Y10
X15
X100
M30
=== truth
0 10.001 0
100 10.001 0
0 10.001 0
0 10 0
15 10 0
20 10 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 10.001 0 t0.04
2: rapid to 100 10.001 0 t0.4
3: rapid to 0 10.001 0 t0.4
4: rapid to 0 10 0 t0
5: rapid to 15 10 0 t0.06
6: event forbidden_zone zone=3 alarm=3043 message="inner forbidden zone 3"
6: rapid to 20 10 0 t0.02
main.nc:6:1: error[nct-3043]: inner forbidden zone 3
    X100
    ^~~~
alarm: 6 blocks, 6 motions, 1 errors, 0 warnings

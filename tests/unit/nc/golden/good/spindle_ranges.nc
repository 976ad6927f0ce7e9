=== about
Ranges (8.3): without overlap S chooses; between and beyond them the nearest speed is taken.
proves: nct-11.3-M11-M18 nct-11.1-S
=== settings
spindle = 1 range 50 1000 range 1001 4000
=== main
S900 M3
G1 X10 F100
S3000
X20
S5000
X30
S20
X40
S1000.4
X50
M11 S2000
X60
M30
=== truth
10 0 0 S 900
20 0 0 S 3000
30 0 0 S 4000
40 0 0 S 50
50 0 0 S 1000
60 0 0 S 1000
=== expect
file 0 main.nc
1: event spindle rpm=900 direction="cw"
2: feed from 0 0 0 to 10 0 0 F100 t6
3: event spindle rpm=3000 direction="cw"
4: feed to 20 0 0 F100 t6
main.nc:5:1: warning[nct-spindle-range]: S5000 lies outside range 2: the spindle turns with 4000
    S5000
    ^~~~~
5: event spindle rpm=4000 direction="cw"
6: feed to 30 0 0 F100 t6
main.nc:7:1: warning[nct-spindle-range]: S20 lies outside range 1: the spindle turns with 50
    S20
    ^~~
7: event spindle rpm=50 direction="cw"
8: feed to 40 0 0 F100 t6
main.nc:9:1: warning[nct-spindle-range]: S1000.4 lies outside range 1: the spindle turns with 1000
    S1000.4
    ^~~~~~~
9: event spindle rpm=1000 direction="cw"
10: feed to 50 0 0 F100 t6
main.nc:11:1: warning[nct-spindle-range]: S2000 lies outside range 1: the spindle turns with 1000
    M11 S2000
    ^~~~~~~~~
11: event function code="M11"
12: feed to 60 0 0 F100 t6
13: event end code="M30"
end of program: 13 blocks, 6 motions, 0 errors, 4 warnings

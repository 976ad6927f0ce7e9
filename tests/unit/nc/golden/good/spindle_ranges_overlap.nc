=== about
Overlapping ranges: M11 to M18 choose, and stay.
proves: nct-11.3-M11-M18
=== settings
spindle = 1 range 50 1000 range 800 4000
=== main
M12 S900 M3
G1 X10 F100
S850
X20
S300
X30
M11
S900
X40
M12 S500
X50
M30
=== truth
10 0 0 S 900
20 0 0 S 850
30 0 0 S 300
40 0 0 S 900
50 0 0 S 800
=== expect
file 0 main.nc
1: event function code="M12"
1: event spindle rpm=900 direction="cw"
2: feed from 0 0 0 to 10 0 0 F100 t6
3: event spindle rpm=850 direction="cw"
4: feed to 20 0 0 F100 t6
5: event spindle rpm=300 direction="cw"
6: feed to 30 0 0 F100 t6
7: event function code="M11"
8: event spindle rpm=900 direction="cw"
9: feed to 40 0 0 F100 t6
main.nc:10:1: warning[nct-spindle-range]: S500 lies outside range 2: the spindle turns with 800
    M12 S500
    ^~~~~~~~
10: event function code="M12"
10: event spindle rpm=800 direction="cw"
11: feed to 50 0 0 F100 t6
12: event end code="M30"
end of program: 12 blocks, 5 motions, 0 errors, 1 warnings

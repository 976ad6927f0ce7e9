=== about
Clocks in milliseconds of the simulated time: #3001 runs always, #3002 on feed motions; both can be set. Date and time are
those of the settings, the time goes on with the cycle: 23:59:58 and 3 s. Parts are counted by the M function of N2305.
proves: nct-23.1.9-3001 nct-23.1.9-3002 nct-23.1.9-3011 nct-23.1.9-3901 nct-13.1-partcount
=== settings
date = 20140518
time = 235958
N2305 = 77
=== main
G4 P2
G1 X10 F600
#100=#3001
#101=#3002
#102=#3012
#3001=0
#3002=500
G4 P0.25
X30
#103=#3001
#104=#_CLOCK2
#105=#_DATE
#106=#_TIME
G0 X#100 Y#101 Z#102
X#103 Y#104 Z#105
M77
M78
M77
#3902=12
#107=#3901
#3901=10
M77
X#107 Y#_PRTSA Z#_PRTSN
M30
=== truth
10 0 0
30 0 0
3000 1000 1
2250 2500 20140518
2 11 12
=== expect
file 0 main.nc
1: event dwell seconds=2
2: feed from 0 0 0 to 10 0 0 F600 t1
8: event dwell seconds=0.25
9: feed to 30 0 0 F600 t2
14: rapid to 3000 1000 1 t11.88
15: rapid to 2250 2500 20140518 t80562.068
main.nc:16:1: warning[nct-m-function]: M77 is a function of the machine builder: it has no effect in the simulation
    M77
    ^~~
16: event function code="M77"
main.nc:17:1: warning[nct-m-function]: M78 is a function of the machine builder: it has no effect in the simulation
    M78
    ^~~
17: event function code="M78"
18: event function code="M77"
22: event function code="M77"
23: rapid to 2 11 12 t80562.024
24: event end code="M30"
end of program: 24 blocks, 5 motions, 0 errors, 2 warnings

=== about
F keeps its number when the unit changes: 100 mm/min become 100 inch/min, with a warning.
proves: nct-5.2-G20
=== main
G1 X1 F100
G20
X2
M30
=== truth
1 0 0 F 100
50.8 0 0 F 2540
=== says
warning[nct-feed-unit]
=== expect
file 0 main.nc
1: feed from 0 0 0 to 1 0 0 F100 t0.6
main.nc:2:1: warning[nct-feed-unit]: the unit changes: the modal feed keeps its number and takes the new unit
    G20
    ^~~
3: feed to 50.8 0 0 F2540 t1.1764
4: event end code="M30"
end of program: 4 blocks, 2 motions, 0 errors, 1 warnings

=== about
A program with waiting codes runs alone: it waits for no other, and says so once. A code for the channel itself
is no waiting.
proves: nct-14.5-wait
=== settings
N2201 = 500
N2202 = 599
=== main
G1 X10 F600
M501 P12
M502 P23
M503 P1
X20
M30
=== truth
10 0 0
20 0 0
=== says
main.nc:2:1: note[nct-wait]
=== expect
file 0 main.nc
1: feed from 0 0 0 to 10 0 0 F600 t1
main.nc:2:1: note[nct-wait]: M501 P12: one channel runs, it waits for no other
    M501 P12
    ^~~~~~~~
5: feed to 20 0 0 F600 t1
6: event end code="M30"
end of program: 6 blocks, 2 motions, 0 errors, 0 warnings

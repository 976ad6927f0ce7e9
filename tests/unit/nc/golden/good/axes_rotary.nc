=== about
A rotary axis C and a named axis Z1 parallel to Z: words with and without names, shifts, G28, rates.
proves: nct-2.2-extname nct-1.1-ABC
=== settings
axis = C 6 rotary carries nothing rapid 3600 start 10 limit -400 400
axis = Z1 4 linear parallel Z rapid 6000
=== main
G0 X10 C45
G1 Z1=-5 F600
X20 CI45
G91 C-30 Z1=I1
G90 G20 C15
G21 G52 C5
G0 C0
G92 C100
C110
G28 C100
C500
M30
=== truth
rapid 10 0 0
feed 10 0 -5
feed 20 0 -5
feed 20 0 -4
feed 20 0 -4
rapid 20 0 -4
rapid 20 0 -4
rapid 20 0 -4
rapid 20 0 -4
rapid 20 0 -4
=== expect
file 0 main.nc
main.nc:1:8: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G0 X10 C45
           ^~~
1: rapid from 0 0 0 to 10 0 0 C 10 to 45 t0.5833
2: feed to 10 0 -5 C 45 to 45 F600 t0.5
3: feed to 20 0 -5 C 45 to 90 F600 t4.6098
4: feed to 20 0 -4 C 90 to 60 F600 t3.0017
main.nc:5:1: warning[nct-feed-unit]: the unit changes: the modal feed keeps its number and takes the new unit
    G90 G20 C15
    ^~~~~~~~~~~
5: feed to 20 0 -4 C 60 to 15 F15240 t0.1772
main.nc:6:1: warning[nct-feed-unit]: the unit changes: the modal feed keeps its number and takes the new unit
    G21 G52 C5
    ^~~~~~~~~~
7: rapid to 20 0 -4 C 15 to 5 t0.1667
9: rapid to 20 0 -4 C 5 to 15 t0.1667
main.nc:10:1: warning[nct-reference]: the job does not give reference point 1: the start position is taken; a job file tells it by reference_points under [machine]
    G28 C100
    ^~~~~~~~
10: rapid to 20 0 -4 C 15 to 5 t0.1667
10: rapid to 20 0 -4 C 5 to 0 t0.0833
11: event overtravel axis="C" value=405 limit=400
11: rapid to 20 0 -4 C 0 to 405 t6.75
12: event end code="M30"
end of program: 12 blocks, 10 motions, 0 errors, 3 warnings

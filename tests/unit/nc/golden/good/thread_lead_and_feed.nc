=== about
The lead is kept for the next thread and never becomes the feed.
proves: nct-4.4-F nct-4.4-chain
=== main
G1 X1 F100 S100 M3
G33 Z-10 F2
G33 Z-20
G1 X5
G33 Z-30
M30
=== truth
feed 1 0 0 F 100
thread 1 0 -10 F 200 t 3
thread 1 0 -20 F 200 t 3
feed 5 0 -20 F 100
thread 5 0 -30 F 200 t 3
=== expect
file 0 main.nc
1: event spindle rpm=100 direction="cw"
1: feed from 0 0 0 to 1 0 0 F100 t0.6
2: event thread lead=2 angle=0
2: thread to 1 0 -10 F200 t3
3: thread to 1 0 -20 F200 t3
4: feed to 5 0 -20 F100 t2.4
5: event thread lead=2 angle=0
5: thread to 5 0 -30 F200 t3
6: event end code="M30"
end of program: 6 blocks, 5 motions, 0 errors, 0 warnings

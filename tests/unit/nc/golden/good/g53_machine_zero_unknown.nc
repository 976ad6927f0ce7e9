=== about
Nothing says where machine zero lies: G53 takes Z to the top of travel, where the machine starts, and the warning names
the key. An offset that the program sets tells it.
proves: nct-10.1.1-G53
=== settings
start = 5 5 100
=== main
G0 Z10
G53 G0 Z0
G0 Z10
G53 G0 X1 Y2 Z-150
G0 Z10
G53 Z250
G10 L2 P1 Z-300
G0 X0 Y0 Z10
G53 Z0
M30
=== truth
5 5 10
5 5 100
5 5 10
1 2 100
1 2 10
1 2 250
0 0 -290
0 0 0
=== says
tells machine zero by G54 under [offsets.work]
=== expect
file 0 main.nc
1: rapid from 5 5 100 to 5 5 10 t0.36
main.nc:2:1: warning[nct-machine-zero]: G53: nothing says where machine zero lies: Z goes to the top of travel, where the tool starts above the stock; a job file tells machine zero by G54 under [offsets.work], which is the workpiece's zero seen from it
    G53 G0 Z0
    ^~~~~~~~~
2: rapid to 5 5 100 t0.36
3: rapid to 5 5 10 t0.36
4: rapid to 1 2 100 t0.36
5: rapid to 1 2 10 t0.36
6: rapid to 1 2 250 t0.96
8: rapid to 0 0 -290 t2.16
9: rapid to 0 0 0 t1.16
10: event end code="M30"
end of program: 10 blocks, 8 motions, 0 errors, 1 warnings

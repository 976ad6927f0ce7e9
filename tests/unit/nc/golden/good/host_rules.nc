=== about
What only the machine and the person at it do: the axes are referenced from the start, absolute moves and reference points
need no homing, coordinates turned by G10 turn programs alone; axes stay with their channel; switches beyond the limits never
answer.
proves: nct-1.3-ref nct-9-homing nct-10.2.3-jog nct-2.3-swap nct-22.1-switch
=== settings
reference1 = 0 0 50
limit_X = -100 100
=== main
G53 X10 Y20 Z30
G28 Z30
#120001=90
G0 X1 Y2
G53 X120
M30
=== truth
10 20 30
10 20 50
-2 1 50
120 1 50
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 20 30 t0.12
2: rapid to 10 20 50 t0.08
4: rapid to -2 1 50 t0.076
5: event overtravel axis="X" value=120 limit=100
5: rapid to 120 1 50 t0.488
6: event end code="M30"
end of program: 6 blocks, 4 motions, 0 errors, 0 warnings

=== about
Values at addresses: the operator I with a sign and a variable; M3.23 is M3, M3.6 is M4.
proves: nct-23.1.1-ref nct-5.1-I
=== main
#24=135.342
#120=104
#100=2
G0 X200
XI-#24
G1 Y#[#120-4] F100
#112=3.23
M#112 S500
G1 Z1
#112=3.6
M#112
Z2
M30
=== truth
200 0 0
64.658 0 0
64.658 2 0
64.658 2 1 S 500
64.658 2 2 S -500
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 200 0 0 t0.8
5: rapid to 64.658 0 0 t0.5414
6: feed to 64.658 2 0 F100 t1.2
8: event spindle rpm=500 direction="cw"
9: feed to 64.658 2 1 F100 t0.6
11: event spindle rpm=500 direction="ccw"
12: feed to 64.658 2 2 F100 t0.6
13: event end code="M30"
end of program: 13 blocks, 5 motions, 0 errors, 0 warnings

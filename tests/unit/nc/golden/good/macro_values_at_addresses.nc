=== about
Values are rounded to the digits of the address: M3.23 is M3, M4.6 is M5.
proves: nct-23.2-formula nct-23.1.1-ref
=== main
#10=90
#11=17.04
#1=1.02
#100=100
#120=104
#5=-2.5
G#10 G#11 G0 XI-#5 Y#[#120-4]
G#1 X[#[100]/5] F#100
#112=3.23
M#112 S500
#112=4.6
M#112
M30
=== truth
rapid 2.5 100 0
feed 20 100 0
=== expect
file 0 main.nc
7: rapid from 0 0 0 to 2.5 100 0 t0.4
8: feed to 20 100 0 F100 t10.5
10: event spindle rpm=500 direction="cw"
12: event spindle rpm=0 direction="stop"
13: event end code="M30"
end of program: 13 blocks, 2 motions, 0 errors, 0 warnings

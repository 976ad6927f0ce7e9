=== about
The manual's second example of 21.1: contact at X130, the next absolute block moves by 170. A box that the move passes by
answers nothing: the end point is stored. P2 is another input of the same probe.
proves: nct-21.1-G31
=== settings
probe = plane 1 0 0 130
probe = box 60 5 -10 70 20 10
=== main
N1 G31 G90 X200 F100
N2 G1 X300 Y100
G0 X0 Y0
G31 P2 X50
#100=#5061
G0 Y10
G31 P8 X90 F50
G0 X#100 Y#5062 Z#5061
M30
=== truth
probe 130 0 0
feed 300 100 0
rapid 0 0 0
probe 50 0 0
50 10 0
probe 60 10 0 F 50
50 10 60
=== expect
file 0 main.nc
1 N1: probe from 0 0 0 to 130 0 0 F100 t78
1 N1: event probe contact=true
2 N2: feed to 300 100 0 F100 t118.3385
3: rapid to 0 0 0 t1.2
4: probe to 50 0 0 F100 t30
4: event probe contact=false
6: rapid to 50 10 0 t0.04
7: probe to 60 10 0 F50 t12
7: event probe contact=true
8: rapid to 50 10 60 t0.24
9: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings

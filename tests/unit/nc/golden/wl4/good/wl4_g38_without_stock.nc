=== about
Digest wl4, 4.8: without anything to touch the tool goes to the end and back; the variables hold the end.
proves: wl4-5.3-G38 wl4-5.3-1000 wl4-5.3-1010 wl4-5.3-1020 wl4-9.2-132
=== settings
control = wl4-mill
G54 = 0 10 0
=== main
%TOUCH
G54 G0 X0 Y0 Z0
G94 G38 G1 Y100 F200
IF (ABS(#132-#1011)>0.01) N010
X#1001 Z#1011 Y#1021
G38 G2 X10 Y90 R100 F200
N010 M30
%
=== truth
probe 0 100 0
probe 0 0 0
feed 110 100 100
probe 10 90 100
probe 110 100 100
=== expect
file 0 main.nc
main.nc:3:1: warning[wl4-no-probe]: there is no stock here that a measuring move could touch: it goes to its end
    G94 G38 G1 Y100 F200
    ^~~~~~~~~~~~~~~~~~~~
3: probe from 0 0 0 to 0 100 0 F200 t30
3: event probe contact=false
3: probe to 0 0 0 F200 t30
5: feed to 110 100 100 F200 t53.7494
6: probe arc to 10 90 100 center 51.3971 181.029 100 normal 0 0 1 sweep -60.3302 F200 t31.5888
6: event probe contact=false
6: probe arc to 110 100 100 center 51.3971 181.029 100 normal 0 0 1 sweep 60.3302 F200 t31.5888
7 N10: event end code="M30"
end of program: 5 blocks, 5 motions, 0 errors, 1 warnings

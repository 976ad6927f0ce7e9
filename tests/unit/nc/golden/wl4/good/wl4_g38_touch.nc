=== about
Digest wl4, 4.8: the touch at Y40 is read; G92 puts the zero 6.54 mm from it.
proves: wl4-5.3-G38 wl4-5.3-1010 wl4-5.9-G92
=== settings
control = wl4-mill
probe = plane 0 1 0 40
=== main
%TOUCH
G54 G0 X0 Y0 Z0
G94G38G1Y100F200
IF (ABS(#132-#1011)>0.01) N010
N05 M0 N05 $ the probe did not touch
N010 G92 Y(-#1011+6.54)
G1 Y6.54
M30
%
=== truth
probe 0 40 0
probe 0 0 0
feed 0 40 0
=== expect
file 0 main.nc
3: probe from 0 0 0 to 0 40 0 F200 t12
3: event probe contact=true
3: probe to 0 0 0 F200 t12
7: feed to 0 40 0 F200 t12
8: event end code="M30"
end of program: 6 blocks, 3 motions, 0 errors, 0 warnings

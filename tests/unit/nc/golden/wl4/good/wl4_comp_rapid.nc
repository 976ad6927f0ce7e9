=== about
Corners outside at rapid: chords within a thousandth in place of the arc.
proves: wl4-6.2-G42
=== settings
control = wl4-mill
D1 = 0.02
=== main
%RAPID
G54 G0 X0 Y0
G41 D1 X10
Y10
X30
G40 Y0
M30
%
=== truth
rapid 9.98 0 0
rapid 9.98 10 0
rapid 9.9827 10.01 0
rapid 9.99 10.0173 0
rapid 10 10.02 0
rapid 30 10.02 0
rapid 30 0 0
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 9.98 0 0 t0.0399
4: rapid to 9.98 10 0 t0.04
4: rapid to 9.9827 10.01 0 t0
4: rapid to 9.99 10.0173 0 t0
4: rapid to 10 10.02 0 t0
5: rapid to 30 10.02 0 t0.08
6: rapid to 30 0 0 t0.0401
7: event end code="M30"
end of program: 6 blocks, 7 motions, 0 errors, 0 warnings

=== about
An offset larger than an inner arc: what stands before it is cut, then the run stops.
Truth: 5.6.7; the groove is 2 wide, the wire 1.2 off its wall and so 0.8 off the other one over the whole of X10.
proves: wedm-5.6.7-overcut
=== settings
control = wedm
=== main
T84 T86 C001 G92 X0 Y0;
H001=1200;
G01 G41 H001 X5.;
X10.;
G03 X10. Y2. J1.;
G01 X0;
G40 Y10.;
M02;
=== truth
feed 5 1.2 0 upper 5 1.2 20
length 5.14198
=== says
main.nc:4:1: error[wedm-5.6.7-overcut]
1 motions, 1 errors
=== expect
file 0 main.nc
1: event function code="C001"
1: event coolant code="T84" on=true
1: event coolant code="T86" on=true
3: cut wire lower to 5 1.2 0 upper to 5 1.2 20 F3 t102.8397
main.nc:4:1: error[wedm-5.6.7-overcut]: overcut: with this offset the wire cuts into another part of the contour (near X5.000 Y1.200)
    X10.;
    ^~~~
alarm: 7 blocks, 1 motions, 1 errors, 0 warnings

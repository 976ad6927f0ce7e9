=== about
proves: nct-18-axis
=== settings
axis = W 4 linear parallel Z
=== main
G81 X0 Y0 Z-5 W-5 R2 F100
M30
=== says
main.nc:1:15: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:15: error[nct-2017]: illegal address W: two drill axes in one block
    G81 X0 Y0 Z-5 W-5 R2 F100
                  ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

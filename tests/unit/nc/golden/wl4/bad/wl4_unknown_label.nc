=== about
A jump to a label that is not there.
Truth: 9.4.1, the jump comes behind the motion of its block.
proves: wl4-9.4.1-jmp
=== settings
control = wl4-mill
=== main
%J
G54 G0 X1
X2 N77
M30
%
=== truth
rapid 1 0 0
rapid 2 0 0
=== says
main.nc:3:4: error[wl4-label]
alarm: 2 blocks, 2 motions, 1 errors
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 0 0 t0.004
3: rapid to 2 0 0 t0.004
main.nc:3:4: error[wl4-label]: there is no label N077 in this program
    X2 N77
       ^~~
alarm: 2 blocks, 2 motions, 1 errors, 0 warnings

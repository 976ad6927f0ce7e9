=== about
G96 to the axis with nothing that limits the spindle is told once.
Truth: n = S / (pi D), so that the way from radius r to the axis takes pi r^2 / (F S): 0.392699 min for 50 mm.
=== settings
control = wl4-lathe
=== main
%1
G54 G95 G96 F0.2 S100 M3
G0 X100 Z0
G1 X0
G0 X100 Z-1
G1 X0
M2
%
=== truth
rapid 50 0 0
feed 0 0 0 F 127.3240 t 23.5619
rapid 50 0 -1
feed 0 0 -1 F 127.3240 t 23.5619
length 100
=== says
main.nc:2:1: warning[wl4-surface-speed]
4 motions, 0 errors, 1 warnings
=== expect
file 0 main.nc
main.nc:2:1: warning[wl4-surface-speed]: G96 to the axis without a limit of the spindle's speed: speed and time there are those of no real machine; give G51 S in the program or MAX_SPEED in [control.wl4-mill] or [control.wl4-lathe]
    G54 G95 G96 F0.2 S100 M3
    ^~~~~~~~~~~~~~~~~~~~~~~~
2: event spindle rpm=31830988.618379068 direction="cw"
3: rapid from 0 0 0 to 50 0 0 t0.2
4: feed to 0 0 0 F127.324 t23.5619
5: rapid to 50 0 -1 t0.2
6: feed to 0 0 -1 F127.324 t23.5619
7: event end code="M2"
end of program: 6 blocks, 4 motions, 0 errors, 1 warnings

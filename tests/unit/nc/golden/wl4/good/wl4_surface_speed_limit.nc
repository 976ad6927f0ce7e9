=== about
Facing under G96 with a limit of the speed: 100 m/min is 318.31 1/min at X100 and 1000 at X31.831. At 0.2 mm a turn
the time is the integral of dr / (F n): from r 50 to 15.9155 (50^2 - 15.9155^2) / (2 F v / 2 pi), then 15.9155 / (F
1000). In seconds: (2500 - 253.303) / (2 * 0.2 * 15915.494) * 60 + 15.91549 / 200 * 60 = 21.1746 + 4.7746 = 25.9493.
proves: wl4-5.12-G51S
=== settings
control = wl4-lathe
=== main
%1
G54 G95 G51 S1000
G96 F0.2 S100 M3
G0 X100 Z0
G1 X0
G0 X100
G1 X-20
M2
%
=== truth
rapid 50 0 0
feed 0 0 0 F 115.61019
rapid 50 0 0
feed -10 0 0 F 124.35547
=== expect
file 0 main.nc
3: event spindle rpm=1000 direction="cw"
4: rapid from 0 0 0 to 50 0 0 t0.2
5: feed to 0 0 0 F115.6102 t25.9493
6: rapid to 50 0 0 t0.2
7: feed to -10 0 0 F124.3555 t28.9493
8: event end code="M2"
end of program: 7 blocks, 4 motions, 0 errors, 0 warnings

=== about
proves: nct-10.2.6-G92
=== main
G10 L2 P1 I30
G0 X150 Y100
G92 X90 Y60
G0 X0 Y0
M30
=== truth
79.9038 161.6025 0
31.9615 64.6410 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 79.9038 161.6025 0 t0.6464
4: rapid to 31.9615 64.641 0 t0.3878
5: event end code="M30"
end of program: 5 blocks, 2 motions, 0 errors, 0 warnings

=== settings
N1704 = 65
=== main
G0 X6
M30
=== says
error[nct-parameter]
=== expect
error[nct-parameter]: G65, G66, G66.1 and G67 cannot call system macros (N1704 to N1719)
alarm: 0 blocks, 0 motions, 1 errors, 0 warnings

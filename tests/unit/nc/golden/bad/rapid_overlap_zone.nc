=== about
Rapids that overlap and an area that the axes must not enter: the sharp corner goes round it, the rounded one runs into
it. With t since X started it is at x = 500 t^2, z = 10 - 500 (0.05 - t)^2: x = 0.2 at z = 9.55. The axes stop there.
proves: nct-4.1.2-ROL
=== settings
N0421.ROL = 1
N0422 = 50
acceleration = 1000 1000 1000
N1000.RE2.1 = 1
N1000.RE2.3 = 1
N1001.STE = 1
N1006.1 = 20
N1007.1 = 0.2
N1006.3 = 9.9
N1007.3 = -100
=== main
G0 Z10
X30
Z1
M30
=== says
rapid from 0 0 0 to 0 0 8.75
event forbidden_zone
rapid to 0.2 0 9.5495
alarm:
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 8.75 t0.15
2: rapid to 0.0012 0 8.8269 t0.0016
2: rapid to 0.0049 0 8.9014 t0.0016
2: rapid to 0.011 0 8.9734 t0.0016
2: rapid to 0.0195 0 9.043 t0.0016
2: rapid to 0.0305 0 9.1101 t0.0016
2: rapid to 0.0439 0 9.1748 t0.0016
2: rapid to 0.0598 0 9.2371 t0.0016
2: rapid to 0.0781 0 9.2969 t0.0016
2: rapid to 0.0989 0 9.3542 t0.0016
2: rapid to 0.1221 0 9.4092 t0.0016
2: rapid to 0.1477 0 9.4617 t0.0016
2: rapid to 0.1758 0 9.5117 t0.0016
2: event forbidden_zone zone=2 alarm=3042 message="inner forbidden zone 2"
2: rapid to 0.2 0 9.5495 t0.0012
main.nc:2:1: error[nct-3042]: inner forbidden zone 2
    X30
    ^~~
alarm: 3 blocks, 14 motions, 1 errors, 0 warnings

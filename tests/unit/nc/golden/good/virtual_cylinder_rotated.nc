=== about
Rotation of the unrolled cylinder: 30 degrees of the table are 15.0011 mm along the surface; turned by 90 degrees they lie along X.
proves: nct-16.1-G68 nct-4.6-G7.1
=== settings
axis = A 4 rotary carries nothing
=== main
G18 G0 X-20 A0
G7.1 A28.65
G68 A0 X-20 R90
G1 A30 F500
A30 X-40
G69
G51.1 A0
A30 X-20
G50.1
A0
G7.1 A0
M30
=== truth
rapid -20 0 0
-4.9989 0 0 rotary 0
-4.9989 0 0 rotary 39.9971
-20 0 0 rotary -30
-20 0 0 rotary 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -20 0 0 A 0 to 0 t0.08
2: event virtual_plane code="G7.1" on=true axes="X A" radius=28.65
4: feed to -4.9989 0 0 A 0 to 0 F500 t1.8001
5: feed to -4.9989 0 0 A 0 to 39.9971 F500 t2.4
8: feed to -20 0 0 A 39.9971 to -30 F500 t4.5696
10: feed to -20 0 0 A -30 to 0 F500 t1.8001
11: event virtual_plane code="G7.1" on=false axes="X A"
12: event end code="M30"
end of program: 12 blocks, 5 motions, 0 errors, 0 warnings

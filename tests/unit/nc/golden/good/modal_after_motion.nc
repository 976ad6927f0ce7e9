=== about
Digest nct-5, section 13. A block without a motion calls nothing.
proves: nct-23.3.2-G66 nct-3-G66 nct-23.3.2-G67 nct-3-G67
=== main
G66 P1250 Z-100 R-1 X2 F130
N100 G91 G0 X100
N110 Y30
G4 P1
N120 X#33 M8
N180 X150
G67
X1
M30
=== sub O1250
G0 Z#18
G1 Z#26 F#9
G4 P#24
G0 Z-[#18+#26]
M99
=== truth
rapid 100 0 0
rapid 100 0 -1
feed 100 0 -101 F 130
rapid 100 0 0
rapid 100 30 0
rapid 100 30 -1
feed 100 30 -101 F 130
rapid 100 30 0
rapid 250 30 0
rapid 250 30 -1
feed 250 30 -101 F 130
rapid 250 30 0
rapid 251 30 0
=== says
dwell seconds=2
dwell seconds=2
dwell seconds=1
dwell seconds=2
=== expect
file 0 main.nc
file 1 O1250
2 N100: rapid from 0 0 0 to 100 0 0 t0.4
1/1 depth 1: rapid to 100 0 -1 t0.004
1/2 depth 1: feed to 100 0 -101 F130 t46.1538
1/3 depth 1: event dwell seconds=2
1/4 depth 1: rapid to 100 0 0 t0.404
3 N110: rapid to 100 30 0 t0.12
1/1 depth 1: rapid to 100 30 -1 t0.004
1/2 depth 1: feed to 100 30 -101 F130 t46.1538
1/3 depth 1: event dwell seconds=2
1/4 depth 1: rapid to 100 30 0 t0.404
4: event dwell seconds=1
5 N120: event coolant code="M8" on=true
6 N180: rapid to 250 30 0 t0.6
1/1 depth 1: rapid to 250 30 -1 t0.004
1/2 depth 1: feed to 250 30 -101 F130 t46.1538
1/3 depth 1: event dwell seconds=2
1/4 depth 1: rapid to 250 30 0 t0.404
8: rapid to 251 30 0 t0.004
9: event end code="M30"
end of program: 24 blocks, 13 motions, 0 errors, 0 warnings

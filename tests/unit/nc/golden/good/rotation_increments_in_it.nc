=== about
The manual's rotation with its G91 taken by the letter: increments run in the rotated figure.
proves: nct-16.1-G68 nct-5.1-G91
=== main
N1 G17 G90 G0 X0 Y0
N2 G68 X90 Y60 R80
N3 G1 X60 Y20 F150
N4 G91 X140
N5 G3 Y80 R50
N6 G1 X60
N7 Y20
N8 G69 G90 G0 X0 Y0
M30
=== truth
feed 124.1829 23.5098 0
148.4936 161.3829 0
69.709 175.2748 0 center 103.8919 138.7846 0
80.1279 234.3632 0
60.4317 237.8362 0
rapid 0 0 0
=== expect
file 0 main.nc
3 N3: feed from 0 0 0 to 124.1829 23.5098 0 F150 t50.5555
4 N4: feed to 148.4936 161.3829 0 F150 t56
5 N5: feed arc to 69.709 175.2748 0 center 103.8919 138.7846 0 normal 0 0 1 sweep 106.2602 F150 t37.0918
6 N6: feed to 80.1279 234.3632 0 F150 t24
7 N7: feed to 60.4317 237.8362 0 F150 t8
8 N8: rapid to 0 0 0 t0.9513
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings

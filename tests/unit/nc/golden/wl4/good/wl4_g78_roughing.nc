=== about
Digest wl4, 10.5, TEST_G78: the 18 roughing passes down to the offset contour.
proves: wl4-11.11.2-G78
=== settings
control = wl4-lathe
=== main
%TEST_G78
G54 G95 S500 M3
N12 G0 X10 Z40
N13 G78 G42 G0 X10 Z5 P120 Q124 R0.5 E2 F0.7
M2
N120 G1 X8.5
N121 G1 X8 Z15
N122 G3 X7 Z20 R10
N123 G2 X5 Z25 R8
N124 G1 Z40
%
=== truth
rapid 5 0 40
rapid 5 0 38
feed 3.0000 0 38
feed 3.0000 0 40
rapid 5 0 40
rapid 5 0 38
rapid 5 0 36
feed 3.0000 0 36
feed 3.0000 0 38
rapid 5 0 38
rapid 5 0 36
rapid 5 0 34
feed 3.0000 0 34
feed 3.0000 0 36
rapid 5 0 36
rapid 5 0 34
rapid 5 0 32
feed 3.0000 0 32
feed 3.0000 0 34
rapid 5 0 34
rapid 5 0 32
rapid 5 0 30
feed 3.0000 0 30
feed 3.0000 0 32
rapid 5 0 32
rapid 5 0 30
rapid 5 0 28
feed 3.0000 0 28
feed 3.0000 0 30
rapid 5 0 30
rapid 5 0 28
rapid 5 0 26
feed 3.0000 0 26
feed 3.0000 0 28
rapid 5 0 28
rapid 5 0 26
rapid 5 0 24
feed 2.9356 0 24
feed 2.9960 0 24.9367
feed 3.0000 0 25
feed 3.0000 0 26
rapid 5 0 26
rapid 5 0 24
rapid 5 0 22
feed 3.2036 0 22
feed 2.9356 0 24
rapid 5 0 24
rapid 5 0 22
rapid 5 0 20
feed 4.0313 0 20
feed 3.9690 0 20.1732
feed 3.9334 0 20.2492
feed 3.2036 0 22
rapid 5 0 22
rapid 5 0 20
rapid 5 0 18
feed 4.5164 0 18
feed 4.0313 0 20
rapid 5 0 20
rapid 5 0 18
rapid 5 0 16
feed 4.6051 0 16
feed 4.5164 0 18
rapid 5 0 18
rapid 5 0 16
rapid 5 0 14
feed 4.5252 0 14
feed 4.5009 0 14.9681
feed 4.6051 0 16
rapid 5 0 16
rapid 5 0 14
rapid 5 0 12
feed 4.5752 0 12
feed 4.5252 0 14
rapid 5 0 14
rapid 5 0 12
rapid 5 0 10
feed 4.6252 0 10
feed 4.5752 0 12
rapid 5 0 12
rapid 5 0 10
rapid 5 0 8
feed 4.6752 0 8
feed 4.6252 0 10
rapid 5 0 10
rapid 5 0 8
rapid 5 0 6
feed 4.7252 0 6
feed 4.6752 0 8
rapid 5 0 8
rapid 5 0 6
rapid 5 0 5.5
feed 4.7377 0 5.5
feed 4.7252 0 6
rapid 4.7252 0 40
rapid 5 0 40
=== expect
file 0 main.nc
2: event spindle rpm=500 direction="cw"
3 N12: rapid from 0 0 0 to 5 0 40 t0.16
main.nc:4:1: warning[wl4-monotone]: the contour of G78 turns back along X
    N13 G78 G42 G0 X10 Z5 P120 Q124 R0.5 E2 F0.7
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
4 N13: rapid to 5 0 38 t0.008
4 N13: feed to 3 0 38 F350 t0.3429
4 N13: feed to 3 0 40 F350 t0.3429
4 N13: rapid to 5 0 40 t0.008
4 N13: rapid to 5 0 38 t0.008
4 N13: rapid to 5 0 36 t0.008
4 N13: feed to 3 0 36 F350 t0.3429
4 N13: feed to 3 0 38 F350 t0.3429
4 N13: rapid to 5 0 38 t0.008
4 N13: rapid to 5 0 36 t0.008
4 N13: rapid to 5 0 34 t0.008
4 N13: feed to 3 0 34 F350 t0.3429
4 N13: feed to 3 0 36 F350 t0.3429
4 N13: rapid to 5 0 36 t0.008
4 N13: rapid to 5 0 34 t0.008
4 N13: rapid to 5 0 32 t0.008
4 N13: feed to 3 0 32 F350 t0.3429
4 N13: feed to 3 0 34 F350 t0.3429
4 N13: rapid to 5 0 34 t0.008
4 N13: rapid to 5 0 32 t0.008
4 N13: rapid to 5 0 30 t0.008
4 N13: feed to 3 0 30 F350 t0.3429
4 N13: feed to 3 0 32 F350 t0.3429
4 N13: rapid to 5 0 32 t0.008
4 N13: rapid to 5 0 30 t0.008
4 N13: rapid to 5 0 28 t0.008
4 N13: feed to 3 0 28 F350 t0.3429
4 N13: feed to 3 0 30 F350 t0.3429
4 N13: rapid to 5 0 30 t0.008
4 N13: rapid to 5 0 28 t0.008
4 N13: rapid to 5 0 26 t0.008
4 N13: feed to 3 0 26 F350 t0.3429
4 N13: feed to 3 0 28 F350 t0.3429
4 N13: rapid to 5 0 28 t0.008
4 N13: rapid to 5 0 26 t0.008
4 N13: rapid to 5 0 24 t0.008
4 N13: feed to 2.9356 0 24 F350 t0.3539
4 N13: feed arc to 2.996 0 24.9367 center 10.4356 0 23.9871 normal 0 1 0 sweep 7.1753 F350 t0.161
4 N13: feed arc to 3 0 25 center 2.5 0 25 normal 0 1 0 sweep -7.2737 F350 t0.0109
4 N13: feed to 3 0 26 F350 t0.1714
4 N13: rapid to 5 0 26 t0.008
4 N13: rapid to 5 0 24 t0.008
4 N13: rapid to 5 0 22 t0.008
4 N13: feed to 3.2037 0 22 F350 t0.3079
4 N13: feed arc to 2.9356 0 24 center 10.4356 0 23.9871 normal 0 1 0 sweep 15.4623 F350 t0.347
4 N13: rapid to 5 0 24 t0.0083
4 N13: rapid to 5 0 22 t0.008
4 N13: rapid to 5 0 20 t0.008
4 N13: feed to 4.0313 0 20 F350 t0.1661
4 N13: feed arc to 3.9691 0 20.1732 center -5.8812 0 16.5369 normal 0 1 0 sweep -1.004 F350 t0.0315
4 N13: feed arc to 3.9335 0 20.2492 center 3.5 0 20 normal 0 1 0 sweep -9.6317 F350 t0.0144
4 N13: feed arc to 3.2037 0 22 center 10.4356 0 23.9871 normal 0 1 0 sweep 14.5296 F350 t0.326
4 N13: rapid to 5 0 22 t0.0072
4 N13: rapid to 5 0 20 t0.008
4 N13: rapid to 5 0 18 t0.008
4 N13: feed to 4.5164 0 18 F350 t0.0829
4 N13: feed arc to 4.0313 0 20 center -5.8812 0 16.5369 normal 0 1 0 sweep -11.248 F350 t0.3534
4 N13: rapid to 5 0 20 t0.0039
4 N13: rapid to 5 0 18 t0.008
4 N13: rapid to 5 0 16 t0.008
4 N13: feed to 4.6051 0 16 F350 t0.0677
4 N13: feed arc to 4.5164 0 18 center -5.8812 0 16.5369 normal 0 1 0 sweep -10.9408 F350 t0.3437
4 N13: rapid to 5 0 18 t0.0019
4 N13: rapid to 5 0 16 t0.008
4 N13: rapid to 5 0 14 t0.008
4 N13: feed to 4.5252 0 14 F350 t0.0814
4 N13: feed to 4.501 0 14.9681 F350 t0.166
4 N13: feed arc to 4.6051 0 16 center -5.8812 0 16.5369 normal 0 1 0 sweep -5.6616 F350 t0.1779
4 N13: rapid to 5 0 16 t0.0016
4 N13: rapid to 5 0 14 t0.008
4 N13: rapid to 5 0 12 t0.008
4 N13: feed to 4.5752 0 12 F350 t0.0728
4 N13: feed to 4.5252 0 14 F350 t0.343
4 N13: rapid to 5 0 14 t0.0019
4 N13: rapid to 5 0 12 t0.008
4 N13: rapid to 5 0 10 t0.008
4 N13: feed to 4.6252 0 10 F350 t0.0643
4 N13: feed to 4.5752 0 12 F350 t0.343
4 N13: rapid to 5 0 12 t0.0017
4 N13: rapid to 5 0 10 t0.008
4 N13: rapid to 5 0 8 t0.008
4 N13: feed to 4.6752 0 8 F350 t0.0557
4 N13: feed to 4.6252 0 10 F350 t0.343
4 N13: rapid to 5 0 10 t0.0015
4 N13: rapid to 5 0 8 t0.008
4 N13: rapid to 5 0 6 t0.008
4 N13: feed to 4.7252 0 6 F350 t0.0471
4 N13: feed to 4.6752 0 8 F350 t0.343
4 N13: rapid to 5 0 8 t0.0013
4 N13: rapid to 5 0 6 t0.008
4 N13: rapid to 5 0 5.5 t0.002
4 N13: feed to 4.7377 0 5.5 F350 t0.045
4 N13: feed to 4.7252 0 6 F350 t0.0857
4 N13: rapid to 4.7252 0 40 t0.136
4 N13: rapid to 5 0 40 t0.0011
5: event end code="M2"
end of program: 4 blocks, 96 motions, 0 errors, 1 warnings

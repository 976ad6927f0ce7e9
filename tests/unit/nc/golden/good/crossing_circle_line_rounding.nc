=== about
proves: nct-17.3.3-AL
=== main
N10 G17 G0 X90 Y0
N20 G42 G1 X50 D0 F100
N30 G3 X-50 Y0 R50 ,R15
N40 G1 X-50 Y42.857 ,A171.87 Q-1
N50 G40 G0 Y70
M30
=== truth
90 0 0
50 0 0
44.3780 23.0346 0 center 0 0 0
33.1859 30.9735 0 center 31.0646 16.1242 0
-50 42.857 0
-50 70 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 90 0 0 t0.36
2 N20: feed to 50 0 0 F100 t24
3 N30: feed arc to 44.378 23.0346 0 center 0 0 0 normal 0 0 1 sweep 27.4317 F100 t14.3632
3 N30: feed arc to 33.1859 30.9735 0 center 31.0646 16.1242 0 normal 0 0 1 sweep 54.4383 F100 t8.5511
4 N40: feed to -50 42.857 0 F100 t50.4183
5 N50: rapid to -50 70 0 t0.1086
6: event end code="M30"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings

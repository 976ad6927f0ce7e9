=== about
The manual's short blocks with N3103 = 0.01: the control may leave out N2510 and N2520, whose steps are below it in each axis. The
path keeps every point.
proves: nct-4.7-N3103 nct-4.7-G5.1Q1
=== settings
N3103 = 0.01
=== main
G90 G1 F1000
G5.1 Q1
N2500 X25.432 Y47.847
N2510 X25.434 Y47.843
N2520 X25.437 Y47.839
N2530 X25.439 Y47.835
N2540 X25.440 Y47.831
N2550 X25.442 Y47.827
G5.1 Q0
M30
=== truth
25.432 47.847 0
25.434 47.843 0
25.437 47.839 0
25.439 47.835 0
25.44 47.831 0
25.442 47.827 0
=== expect
file 0 main.nc
2: event smoothing mode=1
3 N2500: feed from 0 0 0 to 25.432 47.847 0 F1000 t3.2512
4 N2510: feed to 25.434 47.843 0 F1000 t0.0003
5 N2520: feed to 25.437 47.839 0 F1000 t0.0003
6 N2530: feed to 25.439 47.835 0 F1000 t0.0003
7 N2540: feed to 25.44 47.831 0 F1000 t0.0002
8 N2550: feed to 25.442 47.827 0 F1000 t0.0003
9: event smoothing mode=0
10: event end code="M30"
end of program: 10 blocks, 6 motions, 0 errors, 0 warnings

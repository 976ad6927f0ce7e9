=== about
proves: nct-17.3-overdet
=== main
G1 X30 F100
X40 Y30 ,A45
M30
=== says
main.nc:2:9: error[nct-2017]
=== expect
file 0 main.nc
1: feed from 0 0 0 to 30 0 0 F100 t18
main.nc:2:9: error[nct-2017]: illegal address ,A: the calculation of intersections needs G41 or G42 (with D0: no offset)
    X40 Y30 ,A45
            ^~~~
alarm: 2 blocks, 1 motions, 1 errors, 0 warnings

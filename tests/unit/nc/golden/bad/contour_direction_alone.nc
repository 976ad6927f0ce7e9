=== about
proves: nct-17.2-A
=== main
G1 ,A30 F100
M30
=== says
main.nc:1:4: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2017]: illegal address ,A: the calculation of intersections needs G41 or G42 (with D0: no offset)
    G1 ,A30 F100
       ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

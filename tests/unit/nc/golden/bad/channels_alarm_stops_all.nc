=== about
An alarm in one channel at 0.5 s stops all: nothing that starts later is in the path.
=== main
G1 X30 F6000
X60
X90
M30
=== channel 2
G1 Y50 F6000
Q7 H
M30
=== says
channel2.nc:2:4: error[nct-2064]
note: in channel 2
cycle 0.5 s
=== expect
file 0 main.nc
[1] 1: feed from 0 0 0 to 30 0 0 F6000 t0.3
file 1 channel2.nc
[2] 1/1: feed from 0 0 0 to 0 50 0 F6000 t0.5
[1] 2: feed to 60 0 0 F6000 t0.3
channel2.nc:2:4: error[nct-2064]: syntax error: H has no value
    Q7 H
       ^
    note: in channel 2
cycle 0.5 s
alarm: 4 blocks, 3 motions, 1 errors, 0 warnings

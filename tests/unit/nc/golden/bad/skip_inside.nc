G0 X1 /2 Y5
M30
=== says
main.nc:1:7: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2064]: syntax error: optional skip must stand at the start of the block
    G0 X1 /2 Y5
          ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

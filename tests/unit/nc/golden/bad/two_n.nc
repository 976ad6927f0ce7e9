N1 N2 G0 X1
M30
=== says
main.nc:1:4: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2064]: syntax error: two N words in one block
    N1 N2 G0 X1
       ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

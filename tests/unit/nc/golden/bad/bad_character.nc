G0 X1 ; comment
M30
=== says
main.nc:1:7: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2064]: syntax error: ';' ends a block or begins a comment on other controls, here comments stand in ( ) (told once)
    G0 X1 ; comment
          ^
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

G0 XY5
M30
=== says
main.nc:1:4: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2064]: syntax error: XY is no word: a word is a letter with a number, text stands in ( )
    G0 XY5
       ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

G92 XI10
M30
=== says
main.nc:1:5: error[nct-2097]
=== expect
file 0 main.nc
main.nc:1:5: error[nct-2097]: illegal incremental movement on axis X: G92 words are absolute
    G92 XI10
        ^~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

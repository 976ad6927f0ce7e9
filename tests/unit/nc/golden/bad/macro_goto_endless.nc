=== settings
block_limit = 50
=== main
N1 GOTO1
M30
=== says
main.nc:1:1: error[nct-endless-loop]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-endless-loop]: an endless loop: the program comes back to line 1 with nothing changed
    N1 GOTO1
    ^~~~~~~~
block limit: 4 blocks, 0 motions, 1 errors, 0 warnings

=== settings
block_limit = 50
=== main
DO1
END1
M30
=== says
main.nc:1:1: error[nct-endless-loop]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-endless-loop]: an endless loop: the program comes back to lines 1 to 2 with nothing changed
    DO1
    ^~~
block limit: 8 blocks, 0 motions, 1 errors, 0 warnings

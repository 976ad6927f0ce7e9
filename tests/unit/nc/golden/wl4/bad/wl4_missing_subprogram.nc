=== about
A subprogram that is not there.
Truth: 10.1; the call is the first block and nothing moves.
proves: wl4-4.2-L
=== settings
control = wl4-mill
=== main
%S
L77
M2
%
=== says
main.nc:2:1: error[wl4-program]: program 77
alarm: 1 blocks, 0 motions, 1 errors
=== expect
file 0 main.nc
main.nc:2:1: error[wl4-program]: program 77 is not among the programs given
    L77
    ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings

=== about
No feed; G96 without S.
Truth: 5.14 wants S with G96, F is 0 at first; nothing moves.
proves: wl4-4.2-F wl4-5.14-G96
=== settings
control = wl4-mill
max_errors = 9
=== main
%F
G54 G1 X10
G96
M30
%
=== says
main.nc:2:1: error[wl4-feed]
main.nc:3:1: error[wl4-speed-mode]
3 blocks, 0 motions, 2 errors
=== expect
file 0 main.nc
main.nc:2:1: error[wl4-feed]: the feed is zero: F is missing
    G54 G1 X10
    ^~~~~~~~~~
main.nc:3:1: error[wl4-speed-mode]: G96 and G97 need a new S in the same block
    G96
    ^~~
4: event end code="M30"
end of program: 3 blocks, 0 motions, 2 errors, 0 warnings

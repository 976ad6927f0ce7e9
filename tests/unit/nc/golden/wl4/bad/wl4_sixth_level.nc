=== about
Five levels below the main program: the sixth is refused.
proves: wl4-10.1-nest
=== settings
control = wl4-mill
=== main
%N
L01
M2
%
%01
L02
M99
%
%02
L03
M99
%
%03
L04
M99
%
%04
L05
M99
%
%05
L06
M99
%
%06
L07
M99
%
%07
L08
M99
%
=== expect
file 0 main.nc
main.nc:22:1: error[wl4-nesting]: program 06 is the sixth level of calls: five are allowed
    L06
    ^~~
    note: called from main.nc:18
    note: called from main.nc:14
    note: called from main.nc:10
    note: called from main.nc:6
    note: called from main.nc:2
alarm: 6 blocks, 0 motions, 1 errors, 0 warnings

=== about
Five levels below the main program: the sixth is refused.
Truth: 10.1, five levels; program 05 is the fifth, its call of 06 the sixth.
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
=== says
main.nc:22:1: error[wl4-nesting]: program 06
called from main.nc:18
called from main.nc:14
called from main.nc:10
called from main.nc:6
called from main.nc:2
alarm: 6 blocks, 0 motions, 1 errors
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

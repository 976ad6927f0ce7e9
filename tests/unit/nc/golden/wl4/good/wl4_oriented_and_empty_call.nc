=== about
The angle of M19 is in the event of the spindle; L010 calls program 01 no time.
Truth: 7.4, P is the angle; 10.1, the digits behind the first two are the count, here 0.
proves: wl4-7.4-M19
=== settings
control = wl4-mill
=== main
%1
G54 M19 P90
L010
M2
%
%01
G1 X5 F100
M99
%
=== says
direction="oriented" angle=90
main.nc:3:1: warning
3 blocks, 0 motions, 0 errors, 1 warnings
=== expect
file 0 main.nc
2: event spindle rpm=0 direction="oriented" angle=90
main.nc:3:1: warning[wl4-no-repetition]: L010 calls program 01 no time: the digits behind the first two are repetitions
    L010
    ^~~~
4: event end code="M2"
end of program: 3 blocks, 0 motions, 0 errors, 1 warnings

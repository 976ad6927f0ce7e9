=== about
Errors of %1 come as its text says.
Truth: the text of N010 in %1, and that nothing moves.
proves: wl4-11-G79
=== settings
control = wl4-lathe
=== main
%O
G54 G79
M2
%
=== says
ERROR -> UNKNOWN CYCLE IN RANGE G70-G79
called from main.nc:2
0 motions, 1 errors
=== expect
file 0 main.nc
file 1 %1
%1:11:1: error[wl4-err-N10]: ERROR -> UNKNOWN CYCLE IN RANGE G70-G79
    N010 M0 N10 .ERROR -> UNKNOWN CYCLE IN RANGE G70-G79
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
    note: called from main.nc:2
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings

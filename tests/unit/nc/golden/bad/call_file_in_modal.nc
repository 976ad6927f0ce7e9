=== main
G66.1 P11
<abc>
M30
=== sub O0011
M99
=== says
main.nc:2:1: error[nct-2017]
=== expect
file 0 main.nc
file 1 O0011
main.nc:2:1: error[nct-2017]: illegal address <>: a file name is no argument
    <abc>
    ^~~~~
alarm: 3 blocks, 0 motions, 1 errors, 0 warnings

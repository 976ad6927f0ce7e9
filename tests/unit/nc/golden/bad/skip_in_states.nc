=== about
Measuring needs G15 G40 G50 G50.1 G69 G94.
Truth: alarm 2055 with the state of each block.
proves: nct-21.1-G31
=== settings
max_errors = 20
D1 = 5
=== main
F100
G68 X0 Y0 R10
G31 X5
G69
G95
G31 X5
G94
G51 X0 Y0 Z0 P2
G31 X5
G50
G51.1 X0
G31 X5
G50.1
G16
G31 X5
G15
G41 D1 G1 X10
G31 X20
M30
=== says
main.nc:3:1: error[nct-2055]: probe in state G68
main.nc:6:1: error[nct-2055]: probe in state G95
main.nc:9:1: error[nct-2055]: probe in state G51
main.nc:12:1: error[nct-2055]: probe in state G51.1
main.nc:15:1: error[nct-2055]: probe in state G16
main.nc:18:1: error[nct-2055]: probe in state G41
6 errors
=== expect
file 0 main.nc
main.nc:3:1: error[nct-2055]: probe in state G68
    G31 X5
    ^~~~~~
main.nc:6:1: error[nct-2055]: probe in state G95
    G31 X5
    ^~~~~~
main.nc:9:1: error[nct-2055]: probe in state G51
    G31 X5
    ^~~~~~
main.nc:12:1: error[nct-2055]: probe in state G51.1
    G31 X5
    ^~~~~~
main.nc:15:1: error[nct-2055]: probe in state G16
    G31 X5
    ^~~~~~
main.nc:18:1: error[nct-2055]: probe in state G41
    G31 X20
    ^~~~~~~
17: feed from 0 0 0 to 10 0 0 F100 t6
19: event end code="M30"
end of program: 19 blocks, 1 motions, 6 errors, 0 warnings

=== about
Codes that G12.1 excludes.
proves: nct-4.5-forbid
=== settings
axis = C 4 rotary
max_errors = 20
=== main
G17 G0 X10 C0
G12.1
G18
G52 X1
G92 X1
G55
G53 X0
G28 X0
G30 P2 X0
M30
=== says
main.nc:3:1: error[nct-virtual-forbidden]
main.nc:4:1: error[nct-virtual-forbidden]
main.nc:5:1: error[nct-virtual-forbidden]
main.nc:6:1: error[nct-virtual-forbidden]
main.nc:7:1: error[nct-virtual-forbidden]
main.nc:8:1: error[nct-virtual-forbidden]
main.nc:9:1: error[nct-virtual-forbidden]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 C 0 to 0 t0.04
2: event virtual_plane code="G12.1" on=true axes="X C"
main.nc:3:1: error[nct-virtual-forbidden]: G18 is not allowed during G12.1
    G18
    ^~~
main.nc:4:1: error[nct-virtual-forbidden]: G52 is not allowed during G12.1
    G52 X1
    ^~~~~~
main.nc:5:1: error[nct-virtual-forbidden]: G92 is not allowed during G12.1
    G92 X1
    ^~~~~~
main.nc:6:1: error[nct-virtual-forbidden]: G55 is not allowed during G12.1
    G55
    ^~~
main.nc:7:1: error[nct-virtual-forbidden]: G53 is not allowed during G12.1
    G53 X0
    ^~~~~~
main.nc:8:1: error[nct-virtual-forbidden]: G28 is not allowed during G12.1
    G28 X0
    ^~~~~~
main.nc:9:1: error[nct-virtual-forbidden]: G30 is not allowed during G12.1
    G30 P2 X0
    ^~~~~~~~~
10: event end code="M30"
end of program: 10 blocks, 1 motions, 7 errors, 0 warnings

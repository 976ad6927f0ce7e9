=== about
proves: nct-16.1-G68
=== settings
axis = C 4 rotary
=== main
G17 X100 C0
G12.1
G68 X0 Y0 R30
G13.1
M30
=== says
main.nc:3:1: error[nct-virtual-forbidden]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 C 0 to 0 t0.4
2: event virtual_plane code="G12.1" on=true axes="X C"
main.nc:3:1: error[nct-virtual-forbidden]: G68, G51 and G51.1 during G12.1 and G7.1 are not supported
    G68 X0 Y0 R30
    ^~~~~~~~~~~~~
alarm: 3 blocks, 1 motions, 1 errors, 0 warnings

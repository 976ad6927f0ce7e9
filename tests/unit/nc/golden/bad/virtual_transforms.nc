=== about
What stays forbidden: single factors in a virtual plane, ending the mode while a transform is on, rotating a plane with a rotary axis outside the
modes.
Truth: alarm 2088 and the blocks that are refused.
=== settings
axis = C 4 rotary
max_errors = 10
=== main
G17 G0 X100 C0
G68 X0 C0 R30
G12.1
G51 X0 I2
G68 X0 C0 R30
G13.1
G69
G51.1 C0
G13.1
G50.1
G13.1
M30
=== truth
rapid 100 0 0
=== says
main.nc:2:1: error[nct-2088]
3: event virtual_plane code="G12.1" on=true
main.nc:4:1: error
main.nc:6:1: error
main.nc:9:1: error
11: event virtual_plane code="G12.1" on=false
1 motions, 4 errors
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 100 0 0 C 0 to 0 t0.4
main.nc:2:1: error[nct-2088]: illegal plane selection: G68 rotates planes of linear axes
    G68 X0 C0 R30
    ^~~~~~~~~~~~~
3: event virtual_plane code="G12.1" on=true axes="X C"
main.nc:4:1: error[nct-virtual-forbidden]: G51 takes P during G12.1 and G7.1: I, J, K are factors of X, Y, Z
    G51 X0 I2
    ^~~~~~~~~
main.nc:6:1: error[nct-virtual-frame]: G13.1 cannot be switched in a rotated coordinate system, nor while mirroring, scaling or rotation (G51.1, G51, G68) is on
    G13.1
    ^~~~~
main.nc:9:1: error[nct-virtual-frame]: G13.1 cannot be switched in a rotated coordinate system, nor while mirroring, scaling or rotation (G51.1, G51, G68) is on
    G13.1
    ^~~~~
11: event virtual_plane code="G12.1" on=false axes="X C"
12: event end code="M30"
end of program: 12 blocks, 1 motions, 4 errors, 0 warnings

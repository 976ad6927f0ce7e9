=== about
The radius word of G16 is a diameter where the words of its axis are, with a warning.
proves: nct-5.4-G16 nct-5.3-DIA
=== settings
N0106.DIA.1 = 1
=== main
G16 G0 X20 Y90
G15
M30
=== truth
0 10 0
=== says
warning[nct-polar-diameter]
=== expect
file 0 main.nc
main.nc:1:8: warning[nct-polar-diameter]: G16: the radius word is a diameter, as the words of its axis are
    G16 G0 X20 Y90
           ^~~
1: rapid from 0 0 0 to 0 10 0 t0.04
3: event end code="M30"
end of program: 3 blocks, 1 motions, 0 errors, 1 warnings

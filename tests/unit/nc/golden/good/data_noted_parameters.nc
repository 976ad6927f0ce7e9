=== about
Parameters of what only a person at the machine does are accepted, with a note. Diameters shown in the table (N1402)
do not change R of G10: it is a radius.
proves: nct-15.1-N1415 nct-15.2-N1402-DIA nct-15.2-G10-L12
=== settings
N1402.DIA = 1
N1415 = 0.5
=== main
G10 L12 P1 R5
G0 G41 X0 Y10 D1
Y20
G40 X0
M30
=== truth
-5 10 *
-5 20 *
0 20 *
=== expect
note[nct-noted]: parameter N1402.DIA has no effect in the simulation
note[nct-noted]: parameter N1415 has no effect in the simulation
file 0 main.nc
main.nc:4:1: warning[nct-feed]: onto the offset or off it the tool goes by feed here, and there is no F: rapid is taken
    G40 X0
    ^~~~~~
2: rapid from 0 0 0 to -5 10 0 t0.04
3: rapid to -5 20 0 t0.04
3: rapid to 0 20 0 t0.02
5: event end code="M30"
end of program: 5 blocks, 3 motions, 0 errors, 1 warnings

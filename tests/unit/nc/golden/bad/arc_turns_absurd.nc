=== about
Turns that no machine makes in one block.
=== settings
max_errors = 20
=== main
G2 X0 I-5 Z-1 L20000 F1000
G2 X1 I-5 L2000
G0 X0
G2 X0 I-5 Z-1 L9000 F1000
M30
=== says
main.nc:1:1: error[nct-2002]
main.nc:2:1: error[nct-2002]
5 blocks, 1 motions, 2 errors
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2002]: L data out of range: more than 10000 turns of a circle in one block are not simulated
    G2 X0 I-5 Z-1 L20000 F1000
    ^~~~~~~~~~~~~~~~~~~~~~~~~~
main.nc:2:1: error[nct-2002]: L data out of range: more than 1000 turns of a spiral in one block are not simulated
    G2 X1 I-5 L2000
    ^~~~~~~~~~~~~~~
4: feed arc from 0 0 0 to 0 0 -1 center -5 0 0 normal 0 0 1 sweep -3240000 F1000 t16964.6003
5: event end code="M30"
end of program: 5 blocks, 1 motions, 2 errors, 0 warnings

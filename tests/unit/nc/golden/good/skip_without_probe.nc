=== about
Without anything that answers a measuring move goes to its end and stores that; a warning says so once.
proves: nct-21.1-G31
=== main
G31 G91 X100 F100
G90 G0 Y#5061
G31 Z-5
M30
=== truth
probe 100 0 0
100 100 0
probe 100 100 -5
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-no-probe]: there is no stock here that a measuring move could touch: it goes to its end
    G31 G91 X100 F100
    ^~~~~~~~~~~~~~~~~
1: probe from 0 0 0 to 100 0 0 F100 t60
1: event probe contact=false
2: rapid to 100 100 0 t0.4
3: probe to 100 100 -5 F100 t3
3: event probe contact=false
4: event end code="M30"
end of program: 4 blocks, 3 motions, 0 errors, 1 warnings

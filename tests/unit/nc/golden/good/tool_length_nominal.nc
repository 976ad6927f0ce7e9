=== about
Nothing answers: the tool is taken to be as long as its offset says, a warning says so.
proves: nct-21.3-G37
=== settings
H5 = 10
=== main
G43 G0 Z100 H5
G37 Z50 F200
G0 X#10005
M30
=== truth
0 0 110
rapid 0 0 70
probe 0 0 60
10 0 60
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 110 t0.44
2: rapid to 0 0 70 t0.16
main.nc:2:1: warning[nct-no-probe]: there is no stock here that a measuring move could touch: it goes to its end
    G37 Z50 F200
    ^~~~~~~~~~~~
main.nc:2:1: warning[nct-no-gauge]: nothing answers where G37 measures: the tool is taken to be as long as its offset says
    G37 Z50 F200
    ^~~~~~~~~~~~
2: probe to 0 0 60 F200 t3
2: event probe contact=false
3: rapid to 10 0 60 t0.04
4: event end code="M30"
end of program: 4 blocks, 4 motions, 0 errors, 2 warnings

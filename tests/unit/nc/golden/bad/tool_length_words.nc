=== about
G37 measures one axis, absolutely, with an offset in force and in the states of 21.3.
Truth: 21.3 and the numbers of the alarms; H 10 and H 0.
proves: nct-21.3-G37
=== settings
max_errors = 20
H5 = 10
=== main
F100
G37 Z50
G43 G0 Z100 H5
G37 Z50 X3
G37 W50
G37 ZI50
G37 Z50 P1
G95
G37 Z50
G94
G43 H0 Z100
G37 Z50
M30
=== truth
rapid 0 0 110
rapid 0 0 100
=== says
main.nc:2:1: error[nct-2055]: probe in state G49
main.nc:4:1: error[nct-2035]: wrong axis data Z
main.nc:5:5: error
main.nc:6:5: error[nct-2097]
main.nc:7:9: error[nct-2017]
main.nc:9:1: error[nct-2055]: probe in state G95
main.nc:12:1: error[nct-2004]: missing data H
2 motions, 7 errors
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2055]: probe in state G49: G37 corrects the offset in force
    G37 Z50
    ^~~~~~~
3: rapid from 0 0 0 to 0 0 110 t0.44
main.nc:4:1: error[nct-2035]: wrong axis data Z: G37 measures along one axis
    G37 Z50 X3
    ^~~~~~~~~~
main.nc:5:5: error[nct-2097]: illegal incremental movement on axis W: the gauge of G37 is always absolute
    G37 W50
        ^~~
main.nc:6:5: error[nct-2097]: illegal incremental movement on axis Z: the gauge of G37 is always absolute
    G37 ZI50
        ^~~~
main.nc:7:9: error[nct-2017]: illegal address P in this block
    G37 Z50 P1
            ^~
main.nc:9:1: error[nct-2055]: probe in state G95
    G37 Z50
    ^~~~~~~
11: rapid to 0 0 100 t0.04
main.nc:12:1: error[nct-2004]: missing data H: G37 corrects the row of the H in force
    G37 Z50
    ^~~~~~~
13: event end code="M30"
end of program: 13 blocks, 2 motions, 7 errors, 0 warnings

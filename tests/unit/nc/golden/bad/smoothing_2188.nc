=== about
Length compensation cannot change during fine smoothing: G43, H and G49.
proves: nct-4.7.1-2188
=== settings
max_errors = 9
H1 = 5
=== main
G5.1 Q3 X0 Y0 Z0
G43 H1 Z0
G44 H1 Z0
G49
G5.1 Q0
G43 H1 Z0
G5.1 Q3
H0 Z1
G5.1 Q4
G5.1
M30
=== says
error[nct-2188]
=== expect
file 0 main.nc
1: event smoothing mode=3 axes="X Y Z" tolerance=0
main.nc:2:1: error[nct-2188]: G43 not allowed during fine smoothing
    G43 H1 Z0
    ^~~~~~~~~
main.nc:3:1: error[nct-2188]: G44 not allowed during fine smoothing
    G44 H1 Z0
    ^~~~~~~~~
main.nc:4:1: error[nct-2188]: G49 not allowed during fine smoothing
    G49
    ^~~
5: event smoothing mode=0
6: rapid from 0 0 0 to 0 0 5 t0.02
7: event smoothing mode=3 axes="X Y Z" tolerance=0
main.nc:8:1: error[nct-2188]: H not allowed during fine smoothing
    H0 Z1
    ^~~~~
main.nc:9:6: error[nct-2002]: Q data out of range: an integer from 0 to 3 is expected
    G5.1 Q4
         ^~
main.nc:10:1: error[nct-2004]: missing data Q: G5.1 needs Q0 to Q3
    G5.1
    ^~~~
11: event end code="M30"
end of program: 11 blocks, 1 motions, 6 errors, 0 warnings

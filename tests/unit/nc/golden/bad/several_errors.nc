=== about
Interpretation goes on; a bad block changes nothing.
=== settings
max_errors = 10
=== main
G0 X1
G777
X2 Q1
X3
M30
=== says
main.nc:2:1: error[nct-2123]
main.nc:3:4: error[nct-2017]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:2:1: error[nct-2123]: function not implemented: G777 is not a code of this control
    G777
    ^~~~
main.nc:3:4: error[nct-2017]: illegal address Q in this block
    X2 Q1
       ^~
4: rapid to 3 0 0 t0.008
5: event end code="M30"
end of program: 5 blocks, 2 motions, 2 errors, 0 warnings

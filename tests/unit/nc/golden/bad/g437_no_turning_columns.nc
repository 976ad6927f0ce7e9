=== about
Turning lengths need turning columns.
proves: nct-15.1-N1416-TOL
=== settings
N1416.TOL = 0
max_errors = 5
=== main
G43.7 H5
G10 L201 P5 X1
G10 L203 P5 R1
G10 L110 P5 R1
M30
=== says
main.nc:1:1: error[nct-2123]
main.nc:2:5: error[nct-2123]
main.nc:3:5: error[nct-2123]
=== expect
file 0 main.nc
main.nc:1:7: warning[nct-offset-missing]: H5 has no value in the offset table: 0 is taken (--offset H5=VALUE)
    G43.7 H5
          ^~
main.nc:1:1: error[nct-2123]: function not implemented: G43.7: there are no turning columns (N1416.TOL)
    G43.7 H5
    ^~~~~~~~
main.nc:2:5: error[nct-2123]: function not implemented: G10 L200 to L203 need turning columns (N1416.TOL)
    G10 L201 P5 X1
        ^~~~
main.nc:3:5: error[nct-2123]: function not implemented: G10 L200 to L203 need turning columns (N1416.TOL)
    G10 L203 P5 R1
        ^~~~
5: event end code="M30"
end of program: 5 blocks, 0 motions, 3 errors, 1 warnings

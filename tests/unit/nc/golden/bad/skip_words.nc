=== about
P1 to P8 or P98; Q belongs to P98.
Truth: 21.1 and 21.2, P1 to P8 and P98, Q with P98 alone.
proves: nct-21.1-G31
=== settings
max_errors = 20
=== main
F100
G31 P9 X5
G31 P1.5 X5
G31 Q5 X5
G31 P3 I5 X5
M30
=== says
main.nc:2:5: error
main.nc:3:5: error
main.nc:4:5: error[nct-2017]
main.nc:5:8: error[nct-2017]
0 motions, 4 errors
=== expect
file 0 main.nc
main.nc:2:5: error[nct-probe-input]: P specification error: G31 takes P1 to P8 or P98
    G31 P9 X5
        ^~
main.nc:3:5: error[nct-probe-input]: P specification error: G31 takes P1 to P8 or P98
    G31 P1.5 X5
        ^~~~
main.nc:4:5: error[nct-2017]: illegal address Q: G31 takes Q with P98 only
    G31 Q5 X5
        ^~
main.nc:5:8: error[nct-2017]: illegal address I in this block
    G31 P3 I5 X5
           ^~
6: event end code="M30"
end of program: 6 blocks, 0 motions, 4 errors, 0 warnings

=== about
Errors of 21.2: no Q, Q out of range, several axes (the second by number), none.
Truth: numbers of the alarms and the second axis in the order of the axes (21.2).
proves: nct-21.2-G31P98
=== settings
max_errors = 20
=== main
F100
G31 P98 X1
G31 P98 Q0 X1
G31 P98 Q255 X1
G31 P98 Q2.5 X1
G31 P98 Q50 X1 Y2
G31 P98 Q50 Z1 X2
G31 P98 Q50
M30
=== says
main.nc:2:1: error[nct-2004]
main.nc:3:9: error[nct-2039]
main.nc:4:9: error[nct-2039]
main.nc:5:9: error[nct-2039]
main.nc:6:1: error[nct-2035]: wrong axis data Y
main.nc:7:1: error[nct-2035]: wrong axis data Z
main.nc:8:1: error[nct-2035]
0 motions, 7 errors
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2004]: missing data Q: G31 P98 needs the torque Q1 to Q254
    G31 P98 X1
    ^~~~~~~~~~
main.nc:3:9: error[nct-2039]: Q specification error: the torque is Q1 to Q254
    G31 P98 Q0 X1
            ^~
main.nc:4:9: error[nct-2039]: Q specification error: the torque is Q1 to Q254
    G31 P98 Q255 X1
            ^~~~
main.nc:5:9: error[nct-2039]: Q specification error: the torque is Q1 to Q254
    G31 P98 Q2.5 X1
            ^~~~
main.nc:6:1: error[nct-2035]: wrong axis data Y: G31 P98 measures along one axis
    G31 P98 Q50 X1 Y2
    ^~~~~~~~~~~~~~~~~
main.nc:7:1: error[nct-2035]: wrong axis data Z: G31 P98 measures along one axis
    G31 P98 Q50 Z1 X2
    ^~~~~~~~~~~~~~~~~
main.nc:8:1: error[nct-2035]: wrong axis data: G31 P98 needs the word of an axis
    G31 P98 Q50
    ^~~~~~~~~~~
9: event end code="M30"
end of program: 9 blocks, 0 motions, 7 errors, 0 warnings

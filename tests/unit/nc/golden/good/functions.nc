=== about
proves: nct-13.1-M0 nct-13.1-M1 nct-11.2-M4 nct-13.1-M8 nct-13.1-M9 nct-13.1-M2 nct-11.3-M11-M18 nct-11.7.1-M19 nct-13.1-Mother
=== main
M0
M1
S500 M4 M8
M11
S800
M19
M9
M77
M77
M2
=== says
stop code="M0"
optional_stop code="M1" active=false
spindle rpm=500 direction="ccw"
coolant code="M8" on=true
function code="M11"
spindle rpm=800 direction="ccw"
direction="oriented"
coolant code="M9" on=false
function code="M77"
function code="M77"
end code="M2"
=== expect
file 0 main.nc
1: event stop code="M0"
2: event optional_stop code="M1" active=false
3: event spindle rpm=500 direction="ccw"
3: event coolant code="M8" on=true
4: event function code="M11"
5: event spindle rpm=800 direction="ccw"
6: event spindle rpm=0 direction="oriented"
7: event coolant code="M9" on=false
main.nc:8:1: warning[nct-m-function]: M77 is a function of the machine builder: it has no effect in the simulation
    M77
    ^~~
8: event function code="M77"
9: event function code="M77"
10: event end code="M2"
end of program: 10 blocks, 0 motions, 0 errors, 1 warnings

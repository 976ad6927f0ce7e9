=== about
Two M codes of one group (the manual's M400 and M401, and a group of six) contradict each other; codes of two groups do not.
proves: nct-13.1-groups
=== settings
N1342 = 400
N1358 = 401
N1356 = 50
N1372 = 55
max_errors = 5
=== main
M400 M401
M50 M55
M50 M400
M49 M56 M55
M30
=== says
main.nc:1:6: error[nct-contradictory-m]
main.nc:2:5: error[nct-contradictory-m]
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-m-function]: M400 is a function of the machine builder: it has no effect in the simulation
    M400 M401
    ^~~~
main.nc:1:6: error[nct-contradictory-m]: contradictory M codes: M400 and M401
    M400 M401
         ^~~~
main.nc:2:1: warning[nct-m-function]: M50 is a function of the machine builder: it has no effect in the simulation
    M50 M55
    ^~~
main.nc:2:5: error[nct-contradictory-m]: contradictory M codes: M50 and M55
    M50 M55
        ^~~
3: event function code="M50"
3: event function code="M400"
main.nc:4:1: warning[nct-m-function]: M49 is a function of the machine builder: it has no effect in the simulation
    M49 M56 M55
    ^~~
main.nc:4:5: warning[nct-m-function]: M56 is a function of the machine builder: it has no effect in the simulation
    M49 M56 M55
        ^~~
main.nc:4:9: warning[nct-m-function]: M55 is a function of the machine builder: it has no effect in the simulation
    M49 M56 M55
            ^~~
4: event function code="M49"
4: event function code="M56"
4: event function code="M55"
5: event end code="M30"
end of program: 5 blocks, 0 motions, 2 errors, 5 warnings

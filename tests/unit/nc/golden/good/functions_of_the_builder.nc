=== about
M codes of up to eight digits, eight in a block in the order of the text; M90 (the manual's part counter), M400 and M401 (its axis brakes) are
functions of the machine builder: accepted, told in the path, noted once each, and nothing moves.
proves: nct-1.1-M nct-13.1-M90 nct-13.1-M400
=== main
G0 X10
M12345678
M90
M400
X20 M401
M90 M401 M21 M22 M23 M24 M25 M26
X30
M30
=== truth
10 0 0
20 0 0
30 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
main.nc:2:1: warning[nct-m-function]: M12345678 is a function of the machine builder: it has no effect in the simulation
    M12345678
    ^~~~~~~~~
2: event function code="M12345678"
main.nc:3:1: warning[nct-m-function]: M90 is a function of the machine builder: it has no effect in the simulation
    M90
    ^~~
3: event function code="M90"
main.nc:4:1: warning[nct-m-function]: M400 is a function of the machine builder: it has no effect in the simulation
    M400
    ^~~~
4: event function code="M400"
main.nc:5:5: warning[nct-m-function]: M401 is a function of the machine builder: it has no effect in the simulation
    X20 M401
        ^~~~
5: rapid to 20 0 0 t0.04
5: event function code="M401"
main.nc:6:10: warning[nct-m-function]: M21 is a function of the machine builder: it has no effect in the simulation
    M90 M401 M21 M22 M23 M24 M25 M26
             ^~~
main.nc:6:14: warning[nct-m-function]: M22 is a function of the machine builder: it has no effect in the simulation
    M90 M401 M21 M22 M23 M24 M25 M26
                 ^~~
main.nc:6:18: warning[nct-m-function]: M23 is a function of the machine builder: it has no effect in the simulation
    M90 M401 M21 M22 M23 M24 M25 M26
                     ^~~
main.nc:6:22: warning[nct-m-function]: M24 is a function of the machine builder: it has no effect in the simulation
    M90 M401 M21 M22 M23 M24 M25 M26
                         ^~~
main.nc:6:26: warning[nct-m-function]: M25 is a function of the machine builder: it has no effect in the simulation
    M90 M401 M21 M22 M23 M24 M25 M26
                             ^~~
main.nc:6:30: warning[nct-m-function]: M26 is a function of the machine builder: it has no effect in the simulation
    M90 M401 M21 M22 M23 M24 M25 M26
                                 ^~~
6: event function code="M90"
6: event function code="M401"
6: event function code="M21"
6: event function code="M22"
6: event function code="M23"
6: event function code="M24"
6: event function code="M25"
6: event function code="M26"
7: rapid to 30 0 0 t0.04
8: event end code="M30"
end of program: 8 blocks, 3 motions, 0 errors, 10 warnings

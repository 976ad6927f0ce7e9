=== about
Programs of other controls have subprograms behind the end of the main one, and repeats in front of the number.
=== settings
max_errors = 20
=== main
O50
M98 P12
M98 P30013
M98 P14
M97 P100
M30
O12
M99
=== says
O12 is in this file, on line 7: this control wants it as a file of its own
write P13 L3
error[nct-2017]: illegal address P: M97 switches the interrupt macro off here
=== expect
file 0 main.nc
main.nc:2:1: error[nct-2147]: file not found: program O0012 is not among the programs given; O12 is in this file, on line 7: this control wants it as a file of its own
    M98 P12
    ^~~~~~~
main.nc:3:1: error[nct-2147]: file not found: program O00030013 is not among the programs given; for O13 3 times, as other controls read it, write P13 L3
    M98 P30013
    ^~~~~~~~~~
main.nc:4:1: error[nct-2147]: file not found: program O0014 is not among the programs given
    M98 P14
    ^~~~~~~
main.nc:5:1: warning[nct-interrupt]: M96 and M97 are functions of the machine builder: interrupt macros are off (N1758.USD = 0)
    M97 P100
    ^~~
main.nc:5:5: error[nct-2017]: illegal address P: M97 switches the interrupt macro off here; other controls call the part of this program from block N of that number on with it: make a file of it and call that with M98 P
    M97 P100
        ^~~~
6: event end code="M30"
end of program: 5 blocks, 0 motions, 4 errors, 1 warnings

=== about
Auxiliary functions are whole numbers of up to 8 digits; letters that are neither axis nor auxiliary stay refused.
proves: nct-13.2-aux
=== settings
N1333 = 66
max_errors = 10
=== main
B1.5
B123456789
B1 B2
BI5
A1
M30
=== says
main.nc:1:1: error[nct-2002]
main.nc:2:1: error[nct-2002]
main.nc:3:4: error[nct-duplicate-word]
main.nc:4:1: error[nct-2002]
main.nc:5:1: error[nct-2035]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2002]: B data out of range: an auxiliary function is a whole number of up to 8 digits
    B1.5
    ^~~~
main.nc:2:1: error[nct-2002]: B data out of range: an auxiliary function is a whole number of up to 8 digits
    B123456789
    ^~~~~~~~~~
main.nc:3:4: error[nct-duplicate-word]: two B in one block
    B1 B2
       ^~
main.nc:4:1: error[nct-2002]: B data out of range: an auxiliary function is a whole number of up to 8 digits
    BI5
    ^~~
main.nc:5:1: error[nct-2035]: wrong axis data: axis A is not configured
    A1
    ^~
6: event end code="M30"
end of program: 6 blocks, 0 motions, 5 errors, 0 warnings

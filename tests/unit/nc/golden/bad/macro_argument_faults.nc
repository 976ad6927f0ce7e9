=== about
Arguments of functions beyond their range: the manual's five alarms.
proves: nct-23.2.4-SQRT nct-23.2.4-TAN nct-23.2.4-ASIN nct-23.2.4-LN
=== settings
max_errors = 9
=== main
#1=SQRT[-1]
#1=TAN90
#1=TAN[-270]
#1=ASIN1.1
#1=LN0
M30
=== says
error[nct-2122]
error[nct-2116]
error[nct-2116]
error[nct-2117]
error[nct-2118]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2122]: root of a negative value: SQRT of -1
    #1=SQRT[-1]
       ^~~~~~~~
    note: #1 is vacant
main.nc:2:4: error[nct-2116]: absolute value of the argument not less than 90: TAN of 90
    #1=TAN90
       ^~~~~
    note: #1 is vacant
main.nc:3:4: error[nct-2116]: absolute value of the argument not less than 90: TAN of -270
    #1=TAN[-270]
       ^~~~~~~~~
    note: #1 is vacant
main.nc:4:4: error[nct-2117]: absolute value of the argument greater than 1: ASIN of 1.1
    #1=ASIN1.1
       ^~~~~~~
    note: #1 is vacant
main.nc:5:4: error[nct-2118]: value of the argument not positive: LN of 0
    #1=LN0
       ^~~
    note: #1 is vacant
6: event end code="M30"
end of program: 6 blocks, 0 motions, 5 errors, 0 warnings

=== about
Numbers of messages that are not there, values that cannot be shown.
proves: nct-23.1.8-3107 nct-23.1.8-3106
=== settings
max_errors = 10
=== main
#3107=99(too low)
#3107=300(too high)
#3106=1000(too high)
#3006=-1(too low)
#3107=100(value #100)
#3107=100(value #100[00])
#3107=100(value #34[53])
M30
=== says
main.nc:1:1: error[nct-2092]
main.nc:2:1: error[nct-2092]
main.nc:3:1: error[nct-2092]
main.nc:4:1: error[nct-2092]
main.nc:5:1: error[nct-2064]
main.nc:6:1: error[nct-2002]
main.nc:7:1: error[nct-variable]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2092]: value limit exceeded: #3107
    #3107=99(too low)
    ^~~~~~~~
main.nc:2:1: error[nct-2092]: value limit exceeded: #3107
    #3107=300(too high)
    ^~~~~~~~~
main.nc:3:1: error[nct-2092]: value limit exceeded: #3106
    #3106=1000(too high)
    ^~~~~~~~~~
main.nc:4:1: error[nct-2092]: value limit exceeded: #3006
    #3006=-1(too low)
    ^~~~~~~~
main.nc:5:1: error[nct-2064]: syntax error: a variable to be written is followed by its digits in brackets
    #3107=100(value #100)
    ^~~~~~~~~~~~~~~~~~~~~
    note: #100 is vacant
main.nc:6:1: error[nct-2002]: 00 data out of range: 1 to 15 digits can be written
    #3107=100(value #100[00])
    ^~~~~~~~~~~~~~~~~~~~~~~~~
    note: #100 is vacant
main.nc:7:1: error[nct-variable]: #34 cannot be read
    #3107=100(value #34[53])
    ^~~~~~~~~~~~~~~~~~~~~~~~
8: event end code="M30"
end of program: 8 blocks, 0 motions, 7 errors, 0 warnings

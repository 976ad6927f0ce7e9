=== about
Reading parameters with too little: bit, axis and number are missing; a name outside of an assignment.
proves: nct-24.2-PRM
=== settings
max_errors = 9
=== main
#101=PRM[107]/[4]
#101=PRM[107,0]
#101=PRM[]
G0 X[PRM[1339]]
M30
=== says
error[nct-2194]
error[nct-2194]
error[nct-2064]
error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:6: error[nct-2194]: function PRM 2. parameter missing: N107
    #101=PRM[107]/[4]
         ^~~~~~~~~~~~
    note: #101 is vacant
main.nc:2:6: error[nct-2194]: function PRM 3. parameter missing: N107
    #101=PRM[107,0]
         ^~~~~~~~~~
    note: #101 is vacant
main.nc:3:6: error[nct-2064]: syntax error: PRM without a number
    #101=PRM[]
         ^~~~
    note: #101 is vacant
main.nc:4:4: error[nct-2017]: illegal address PRM: parameters are read on the right of an assignment only
    G0 X[PRM[1339]]
       ^~~~~
5: event end code="M30"
end of program: 5 blocks, 0 motions, 4 errors, 0 warnings

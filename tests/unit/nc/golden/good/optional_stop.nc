=== about
proves: nct-13.1-M1 nct-13.1-M30
=== settings
optional_stop = 1
=== main
M1
M30
=== says
optional_stop code="M1" active=true
=== expect
file 0 main.nc
1: event optional_stop code="M1" active=true
2: event end code="M30"
end of program: 2 blocks, 0 motions, 0 errors, 0 warnings

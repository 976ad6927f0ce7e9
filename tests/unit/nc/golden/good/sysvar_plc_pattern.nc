=== about
The manual's bit pattern in four lines: 12345678h becomes 9B345678h. #101 is 00345678h, 3430008; the variable reads 2603898488.
proves: nct-23.2.3-AND nct-23.2.3-XOR nct-23.1.7-out
=== main
#1132=305419896
#100=16777215
#101=#100AND#1132
#102=-1694498816
#1132=#101XOR#102
G0 X[#101-3430000] Y[#1132-2603898488]
M30
=== truth
8 0 0
=== expect
file 0 main.nc
6: rapid from 0 0 0 to 8 0 0 t0.032
7: event end code="M30"
end of program: 7 blocks, 1 motions, 0 errors, 0 warnings

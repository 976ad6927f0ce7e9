=== about
Values of functions to their last digits: LN 2.718281828 is 0.99999999983, ATAN -0.5 is -26.56505118, and formulas in brackets.
proves: nct-23.2.4-LN nct-23.2.4-ATAN nct-23.2.6-brackets nct-23.2.6-precedence
=== main
G0 X[[1-LN2.718281828]*100000000000] Y[[ATAN[-0.5]+26]*10000]
#120=COS[[[5-2]*10+30]*1]
#110=1+2*COS60
X#120 Y#110
#1=[1+2]*[3+4]
#2=15.6
X#1 Y[1000*TAN[#2*2]]
M30
=== truth
16.8873 -5650.5118 0
0.5 2 0
21 605.6215 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 16.8873 -5650.5118 0 t22.602
4: rapid to 0.5 2 0 t22.61
7: rapid to 21 605.6215 0 t2.4145
8: event end code="M30"
end of program: 8 blocks, 3 motions, 0 errors, 0 warnings

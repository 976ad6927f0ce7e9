=== about
The PLC has chosen range B for the upper end of Z; the lower one keeps A.
proves: nct-22.1-stroke
=== settings
N1002.3 = 500
N1003.3 = -300
N1004.3 = 200
N1005.3 = -10
range_b = Z+
max_errors = 9
=== main
G0 Z-250
Z250
M30
=== truth
0 0 -250
0 0 200
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 -250 t1
2: event overtravel axis="Z" value=250 limit=200 alarm=3010
2: rapid to 0 0 200 t1.8
main.nc:2:1: error[nct-3010]: ran onto positive end position on axis Z
    Z250
    ^~~~
3: event end code="M30"
end of program: 3 blocks, 2 motions, 1 errors, 0 warnings

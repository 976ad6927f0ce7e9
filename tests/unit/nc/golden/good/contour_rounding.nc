=== about
proves: nct-1.1-commaR nct-17.1-R
=== main
N1 G17 G91 G01 X30 ,R8 F100
N2 G03 X-30 Y30 R30
M30
=== truth
20.4939 0 0
27.9462 10.9091 0 center 20.4939 8 0
0 30 0 center 0 0 0
=== expect
file 0 main.nc
1 N1: feed from 0 0 0 to 20.4939 0 0 F100 t12.2963
1 N1: feed arc to 27.9462 10.9091 0 center 20.4939 8 0 normal 0 0 1 sweep 111.3237 F100 t9.3262
2 N2: feed arc to 0 30 0 center 0 0 0 normal 0 0 1 sweep 68.6763 F100 t21.5753
3: event end code="M30"
end of program: 3 blocks, 3 motions, 0 errors, 0 warnings

=== about
A changed row acts when H is programmed again.
proves: nct-15.1-table-mill nct-15.2-G10-L10 nct-15.2-G10-L11 nct-15.2-G90-G91-I
=== main
G90 G10 L10 P5 R100
G91 G10 L11 P5 R-0.2
G91 G10 L11 P5 R-0.2
G90 G0 G43 Z0 H5
G10 L10 P5 R50
Z1
Z1 H5
M30
=== truth
0 0 99.6
0 0 100.6
0 0 50.6
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 0 0 99.6 t0.3984
6: rapid to 0 0 100.6 t0.004
7: rapid to 0 0 50.6 t0.2
8: event end code="M30"
end of program: 8 blocks, 3 motions, 0 errors, 0 warnings

=== about
The over-determined block is absolute in G91 too; without Q the first point is taken.
proves: nct-17.3.2-LA
=== main
N10 G17 G42 G0 X100 Y20 D0 F100
N20 G1 X-30 Y-20 ,R15
N30 G91 G3 X20 Y40 I20 J-10 R50
N40 G90 G40 G0 Y60
M30
=== truth
100 20 0
77.5527 13.0931 0
60.8780 18.7922 0 center 73.1414 27.4298 0
20 40 0 center 20 -10 0
20 60 0
=== expect
file 0 main.nc
1 N10: rapid from 0 0 0 to 100 20 0 t0.4
2 N20: feed to 77.5527 13.0931 0 F100 t14.0915
2 N20: feed arc to 60.878 18.7922 0 center 73.1414 27.4298 0 normal 0 0 1 sweep -71.944 F100 t11.3009
3 N30: feed arc to 20 40 0 center 20 -10 0 normal 0 0 1 sweep 54.8413 F100 t28.7148
4 N40: rapid to 20 60 0 t0.08
5: event end code="M30"
end of program: 5 blocks, 5 motions, 0 errors, 0 warnings

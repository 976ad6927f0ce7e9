=== about
R and a centre in one block: R counts. R with an end where the tool stands, and a block of G2 without axis words, do not move. A radius that
changes within N1339 turns at the constant rate F / first radius: 50 mm at F500, half a turn in 18.85 s.
proves: nct-4.3-R nct-4.3-full nct-4.3-vararc
=== settings
N1339 = 30
=== main
G0 X0 Y0 F100
G2 X10 Y0 R5 I3
G2 X10 Y0 R5
G2 F500 N5 M8
G0 X50 Y0
G3 X-20 I-50
M30
=== truth
10 0 0 center 5 0 0 sweep -180
50 0 0
-20 0 0 center 0 0 0 sweep 180 t 18.8496
=== says
warning[nct-arc-both]
coolant code="M8"
=== expect
file 0 main.nc
main.nc:2:1: warning[nct-arc-both]: R and I, J, K in one block: R counts
    G2 X10 Y0 R5 I3
    ^~~~~~~~~~~~~~~
2: feed arc from 0 0 0 to 10 0 0 center 5 0 0 normal 0 0 1 sweep -180 F100 t9.4248
main.nc:3:11: warning[nct-unused-word]: R5 does nothing in this block of G2: the arc ends where it starts; a full circle needs I, J or K
    G2 X10 Y0 R5
              ^~
4 N5: event coolant code="M8" on=true
5: rapid to 50 0 0 t0.16
6: feed arc to -20 0 0 center 0 0 0 normal 0 0 1 sweep 180 F363.5841 t18.8496
7: event end code="M30"
end of program: 7 blocks, 3 motions, 0 errors, 2 warnings

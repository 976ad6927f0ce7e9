=== about
Manual 9.3.3 names two classes of operators, from left to right; below the first one the usual order is taken, and said
where it gives another value. Where both agree nothing is said.
proves: wl4-9.3.3-prio
=== settings
control = wl4-mill
=== main
%ORDER
G54 G90
#1=2 #2=3
G0 X(#1+#2*2)
X(1+#1>#2-1)
X0
X((3>1)-1+2)
X(#1+1>2 AND 0 OR 1)
X(3>1-1+2)
M30
%
=== truth
8 0 0
1 0 0
0 0 0
2 0 0
1 0 0
=== says
warning[wl4-order]
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 8 0 0 t0.032
main.nc:5:1: warning[wl4-order]: operators of several kinds without parentheses: taken here are + and - first, then comparisons, then AND, OR and XOR; the manual names no order among them but from left to right, which gives another value: put parentheses
    X(1+#1>#2-1)
    ^~~~~~~~~~~~
5: rapid to 1 0 0 t0.028
6: rapid to 0 0 0 t0.004
7: rapid to 2 0 0 t0.008
8: rapid to 1 0 0 t0.004
10: event end code="M30"
end of program: 9 blocks, 5 motions, 0 errors, 1 warnings

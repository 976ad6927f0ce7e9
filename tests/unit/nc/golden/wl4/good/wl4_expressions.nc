=== about
Digest wl4, 3.7: assignment inside a block and inside expressions, comparisons as numbers.
proves: wl4-4.2-var wl4-9.3.1-ABS wl4-9.3.2-asg wl4-9.3.2-add wl4-9.3.2-sub wl4-9.3.2-mul wl4-9.3.2-div wl4-9.3.2-lt wl4-9.3.2-gt wl4-9.3.3-prio wl4-4.2-num wl4-4.2-XYZ
=== settings
control = wl4-mill
=== main
%EXPR
G54
N5 #1=10 #2=20 #3=30 #4=40
N10 G90 G0 X#1 Z#2 #1=(#1+#3) #2=(#2+#4)
N15 X#1 Z#2
N20 #5=(#4/2+15*(#3>#4))
X#5
N25 #5=(#4/2+15*(#3<#4))
X#5
#2=20
N30 X#1=(ABS(#3-#4) + #5=(40.78*#2))
Z#1 Y#5
M30
%
=== truth
rapid 10 0 20
rapid 40 0 60
rapid 20 0 60
rapid 35 0 60
rapid 825.6 0 60
rapid 825.6 815.6 825.6
=== expect
file 0 main.nc
4 N10: rapid from 0 0 0 to 10 0 20 t0.08
5 N15: rapid to 40 0 60 t0.16
7: rapid to 20 0 60 t0.08
9: rapid to 35 0 60 t0.06
11 N30: rapid to 825.6 0 60 t3.1624
12: rapid to 825.6 815.6 825.6 t3.2624
13: event end code="M30"
end of program: 12 blocks, 6 motions, 0 errors, 0 warnings

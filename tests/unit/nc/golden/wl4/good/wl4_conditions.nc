=== about
Digest wl4, 3.7: IF adds words to the block; a repeated address counts last; precision; jumps.
proves: wl4-9.4.2-IF wl4-9.4.2-IFp wl4-4.3-last wl4-9.3.2-ge wl4-9.4.1-jmp wl4-9.4.1-lbl wl4-4.4-cmt wl4-4.2-N
=== settings
control = wl4-mill
=== main
%COND
G54
G0 Z50
#1=2 #2=1
N20 G1 X0 Z100 F500 IF ((#1-#2)>0) Z0
#2=3
N21 G1 X0 Z100 F500 IF ((#1-#2)>0) Z0
#1=1.0004 #2=1 #3=0
N01 #3=(#3+1)
IF3 (#1<=#2) #1=(#1+1) N1 $ equal to three decimals: once
X#3
IF(#3<>2) X77
IF(#3) Y#3
M30
%
=== truth
rapid 0 0 50
feed 0 0 0
feed 0 0 100
feed 2 0 100
feed 2 2 100
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 0 0 50 t0.2
5 N20: feed to 0 0 0 F500 t6
7 N21: feed to 0 0 100 F500 t12
11: feed to 2 0 100 F500 t0.24
13: feed to 2 2 100 F500 t0.24
14: event end code="M30"
end of program: 13 blocks, 5 motions, 0 errors, 0 warnings

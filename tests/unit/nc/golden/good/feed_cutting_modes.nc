=== about
proves: nct-6.3.1-G9 nct-6.3.2-G61 nct-6.3.5-G62 nct-6.3.4-G63 nct-6.3.3-G64 nct-16.1-G69 nct-16.2-G50 nct-16.3-G50.1 nct-5.4-G15 nct-4.5-G13.1 nct-3-G23 nct-3-G67 nct-3-G69.1 nct-3-G97
=== main
F100
G61 G1 X10
G62 G1 X20
G63 G1 X30
G64 G1 X40
G9 G1 X50
G40 G49 G80 G69 G50 G67 G15 G97 G13.1 G50.1 G69.1
G23
M30
=== truth
10 0 0
20 0 0
30 0 0
40 0 0
50 0 0
=== expect
file 0 main.nc
2: feed from 0 0 0 to 10 0 0 F100 t6
3: feed to 20 0 0 F100 t6
4: feed to 30 0 0 F100 t6
5: feed to 40 0 0 F100 t6
6: feed to 50 0 0 F100 t6
9: event end code="M30"
end of program: 9 blocks, 5 motions, 0 errors, 0 warnings

=== about
Blocks with and without numbers; numbers in any order, twice, with eight digits, as labels. Codes with a leading zero and in small letters.
Several codes in a block; G9, G53 and G4 act in their own block only, the other codes until the next one of their group.
proves: nct-1.1-block nct-1.1-G nct-3-zero nct-3-group nct-1.3-modal nct-14.1-N
=== settings
G55 = 100 0 0
=== main
N30 G55 G01 G90 X10 F100
N20 G91 X5
X5 G09
N20 G53 G90 X50
X60
G4 P1
X70
GOTO 12345678
N40 X999
N12345678 G00 X1
N41 X2
GOTO41000
N50 X998
N41000 G02 X4 R1 F100
G03 X2 R1
n7 g01 x3
M30
=== truth
feed 110 0 0
feed 115 0 0
feed 120 0 0
50 0 0
feed 160 0 0
feed 170 0 0
rapid 101 0 0
rapid 102 0 0
feed 104 0 0 center 103 0 0 sweep -180
feed 102 0 0 center 103 0 0 sweep 180
feed 103 0 0
=== expect
file 0 main.nc
1 N30: feed from 0 0 0 to 110 0 0 F100 t66
2 N20: feed to 115 0 0 F100 t3
3: feed to 120 0 0 F100 t3
main.nc:4:1: warning[nct-machine-zero]: G53: the job gives no reference point ([machine] reference_points), so machine zero is only as good as its work offsets ([offsets.work])
    N20 G53 G90 X50
    ^~~~~~~~~~~~~~~
4 N20: rapid to 50 0 0 t0.28
5: feed to 160 0 0 F100 t66
6: event dwell seconds=1
7: feed to 170 0 0 F100 t6
10 N12345678: rapid to 101 0 0 t0.276
11 N41: rapid to 102 0 0 t0.004
14 N41000: feed arc to 104 0 0 center 103 0 0 normal 0 0 1 sweep -180 F100 t1.885
15: feed arc to 102 0 0 center 103 0 0 normal 0 0 1 sweep 180 F100 t1.885
16 N7: feed to 103 0 0 F100 t0.6
17: event end code="M30"
end of program: 15 blocks, 11 motions, 0 errors, 1 warnings

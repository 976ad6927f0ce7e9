=== about
Digest nct-5, section 23: the path is the same whenever the control runs its macro blocks.
proves: nct-23.5-blocks nct-23.5-MBM nct-23.5-SBM nct-23.5-G53
=== settings
N1755.SBM = 0
N1301.MBM = 1
=== main
%O1000
N10 #100=50
N20 #101=100
N30 G1 X#100 Y#101 F1000
N40 #100=60
N50 #101=120
G53
N60 G1 X#100 Y#101
M30
=== truth
feed 50 100 0
feed 60 120 0
=== expect
file 0 main.nc
4 N30: feed from 0 0 0 to 50 100 0 F1000 t6.7082
8 N60: feed to 60 120 0 F1000 t1.3416
9: event end code="M30"
end of program: 8 blocks, 2 motions, 0 errors, 0 warnings

=== about
Two one-shot codes that both want the words of the block; G9 goes with a motion.
proves: nct-3-group
=== settings
max_errors = 9
reference2 = 0 0 0
=== main
G28 G30 X1 P2
G4 G92 X1 P1
G9 G53 X1
M30
=== truth
1 0 0
=== says
error[nct-group-clash]: G28 and G30
error[nct-group-clash]: G4 and G92
=== expect
file 0 main.nc
main.nc:1:5: error[nct-group-clash]: G28 and G30 cannot stand in one block
    G28 G30 X1 P2
        ^~~
main.nc:2:4: error[nct-group-clash]: G4 and G92 cannot stand in one block
    G4 G92 X1 P1
       ^~~
main.nc:3:1: warning[nct-machine-zero]: G53: nothing says where machine zero lies: Z goes to the top of travel, where the tool starts above the stock; a job file tells machine zero by G54 under [offsets.work], which is the workpiece's zero seen from it
    G9 G53 X1
    ^~~~~~~~~
3: rapid from 0 0 0 to 1 0 0 t0.004
4: event end code="M30"
end of program: 4 blocks, 1 motions, 2 errors, 1 warnings

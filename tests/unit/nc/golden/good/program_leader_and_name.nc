=== about
The tape of ISO 6983: a leader in front of the first %, a name behind it, the program, %. Both are skipped and noted; with a
warning where blocks are among it.
proves: nct-14.4.1-O
=== main
SHOP FLOOR 3, PART 4711
(of the night shift)
  % FLANGE-7 rev.B
O0010
N10 G0 X10
GOTO 30
N20 X999
N30 Y5
M98 P20
M30
%
=== sub O0020
Punched 2024
%
G0 Z3
M98 P30
M99
%
=== sub O0030
N5 G0 X999
%
G0 Z4
M99
=== truth
10 0 0
10 5 0
10 5 3
10 5 4
=== says
note[nct-leader]
note[nct-tape-name]: FLANGE-7 rev.B
note[nct-leader]
O0030:1:1: warning[nct-leader]: blocks
=== expect
file 0 main.nc
main.nc:1:1: note[nct-leader]: text in front of the first % is skipped, up to there
    SHOP FLOOR 3, PART 4711
    ^~~~~~~~~~~~~~~~~~~~~~~
main.nc:3:5: note[nct-tape-name]: FLANGE-7 rev.B behind % is a name and skipped
      % FLANGE-7 rev.B
        ^~~~~~~~~~~~~~
5 N10: rapid from 0 0 0 to 10 0 0 t0.04
8 N30: rapid to 10 5 0 t0.02
file 1 O0020
O0020:1:1: note[nct-leader]: text in front of the first % is skipped, up to there
    Punched 2024
    ^~~~~~~~~~~~
    note: called from main.nc:9 by M98
1/3 depth 1: rapid to 10 5 3 t0.012
file 2 O0030
O0030:1:1: warning[nct-leader]: blocks in front of the first % are skipped: the program begins behind it
    N5 G0 X999
    ^~~~~~~~~~
    note: called from O0020:4 by M98
    note: called from main.nc:9 by M98
2/3 depth 2: rapid to 10 5 4 t0.004
10: event end code="M30"
end of program: 10 blocks, 4 motions, 0 errors, 1 warnings

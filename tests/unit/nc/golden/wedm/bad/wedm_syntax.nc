=== about
Digest wedm, K24: each of these is an error with its place.
Truth: the place of each word that 1.2, 2.2, 5.1, 8.3, 9 and the table of 13 forbid, and that nothing moves.
proves: wedm-2.2-onemotion wedm-2.2-dupaxis wedm-5.1-space wedm-1.2-Z
=== settings
control = wedm
max_errors = 20
=== main
G92 X0 Y0;
C1;
X 10.;
XA10.;
G01 X1. X2.;
G00 X1. G01 Y1.;
G01 Z5.;
G33 X1.;
M98 P0077;
M02;
=== says
main.nc:2:1: error
main.nc:3:1: error
main.nc:4:1: error
main.nc:5:9: error[wedm-2.2-dupaxis]
main.nc:6:9: error[wedm-2.2-onemotion]
main.nc:7:5: error
main.nc:8:1: error
main.nc:9:
end of program: 10 blocks, 0 motions, 8 errors
=== expect
file 0 main.nc
main.nc:2:1: error[wedm-syntax]: C needs 3 digits directly behind it
    C1;
    ^~
main.nc:3:1: error[wedm-syntax]: no blank may stand between X and its number
    X 10.;
    ^~
main.nc:4:1: error[wedm-syntax]: X needs a number directly behind it
    XA10.;
    ^~
main.nc:5:9: error[wedm-2.2-dupaxis]: X stands twice in the block
    G01 X1. X2.;
            ^~~
main.nc:6:9: error[wedm-2.2-onemotion]: two motion codes in one block: G00 and G01 exclude each other, make two blocks of it
    G00 X1. G01 Y1.;
            ^~~
main.nc:7:5: error[wedm-syntax]: the machine has no motion along Z: remove the word
    G01 Z5.;
        ^
main.nc:8:1: error[wedm-13-code]: the control has no G33: remove it
    G33 X1.;
    ^~~
main.nc:9:1: error[wedm-10-P]: there is no block N0077 behind the M02 of the main program: write the subprogram there, with M99 at its end
    M98 P0077;
    ^~~~~~~~~
10: event end code="M02"
end of program: 10 blocks, 0 motions, 8 errors, 0 warnings

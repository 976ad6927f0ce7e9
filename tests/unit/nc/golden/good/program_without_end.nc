=== about
A text that stops without M2 or M30 may be cut short: it runs to its end, with a warning.
=== main
G0 X1
=== truth
1 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
main.nc:1:1: warning[nct-no-end]: the program ends without M2 or M30: is the file cut short?
    G0 X1
    ^~~~~
1: event end code="end of text"
end of program: 1 blocks, 1 motions, 0 errors, 1 warnings

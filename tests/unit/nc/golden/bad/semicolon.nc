=== about
What other controls end a block or begin a comment with is told once, and what stands behind it is left out.
=== settings
max_errors = 20
=== main
; first
G0 X1 ; second
X2 ; G1 X99
X3 )
M30
=== says
main.nc:1:1: error[nct-2064]: syntax error: ';' ends a block or begins a comment on other controls
main.nc:4:4: error[nct-2064]: syntax error: ')' without '('
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2064]: syntax error: ';' ends a block or begins a comment on other controls, here comments stand in ( ) (told once)
    ; first
    ^
2: rapid from 0 0 0 to 1 0 0 t0.004
3: rapid to 2 0 0 t0.004
main.nc:4:4: error[nct-2064]: syntax error: ')' without '('
    X3 )
       ^
5: event end code="M30"
end of program: 5 blocks, 2 motions, 2 errors, 0 warnings

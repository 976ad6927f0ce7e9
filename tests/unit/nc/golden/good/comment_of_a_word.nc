=== about
A word in parentheses is a comment: the block moves X alone.
proves: nct-14.3-comment
=== settings
axis = A 4 rotary carries nothing
=== main
G1 X-10 A360 F500
N160 G40 X-20 (A380)
M30
=== truth
-10 0 0 rotary 360
-20 0 0 rotary 360
=== expect
file 0 main.nc
main.nc:1:9: note[nct-rotary-told]: axis A turns nothing that the job describes: its position is told, the path does not follow it
    G1 X-10 A360 F500
            ^~~~
1: feed from 0 0 0 to -10 0 0 A 0 to 360 F500 t43.2167
2 N160: feed to -20 0 0 A 360 to 360 F500 t1.2
3: event end code="M30"
end of program: 3 blocks, 2 motions, 0 errors, 0 warnings

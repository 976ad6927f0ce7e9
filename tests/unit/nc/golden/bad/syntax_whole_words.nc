=== about
Text that is no program is named whole; PRM on the left of an assignment is 2017.
proves: nct-24.2-PRM
=== settings
max_errors = 20
=== main
PRM[1339]=1
prm [1339] = 1
MACHINE 5
M117 HELLO
N10 T1 (rough) GOTO 20
X10 Foo
F AST 3
X SIN[0
#100=FOO[3]
G0 XSIN[30] YCOS[0]
M30
=== says
error[nct-2017]: illegal address PRM
error[nct-2017]: illegal address PRM
MACHINE is no word
HELLO is no word
GOTO cannot stand behind other words
FOO is no word
FAST is no word
end
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2017]: illegal address PRM: parameters are read on the right of an assignment only; G10 L52 writes them
    PRM[1339]=1
    ^~~
main.nc:2:1: error[nct-2017]: illegal address PRM: parameters are read on the right of an assignment only; G10 L52 writes them
    prm [1339] = 1
    ^~~
main.nc:3:1: error[nct-2064]: syntax error: MACHINE is no word: a word is a letter with a number, text stands in ( )
    MACHINE 5
    ^~~~~~~
main.nc:4:6: error[nct-2064]: syntax error: HELLO is no word: a word is a letter with a number, text stands in ( )
    M117 HELLO
         ^~~~~
main.nc:5:16: error[nct-2064]: syntax error: GOTO cannot stand behind other words
    N10 T1 (rough) GOTO 20
                   ^~~~
main.nc:6:5: error[nct-2064]: syntax error: FOO is no word: a word is a letter with a number, text stands in ( )
    X10 Foo
        ^~~
main.nc:7:1: error[nct-2064]: syntax error: FAST is no word: a word is a letter with a number, text stands in ( )
    F AST 3
    ^~~~~
main.nc:8:1: error[nct-2121]: right bracket not found
    X SIN[0
    ^~~~~~~
main.nc:9:6: error[nct-2064]: syntax error: a value is expected, and FOO is no function
    #100=FOO[3]
         ^~~
    note: #100 is vacant
10: rapid from 0 0 0 to 0.5 1 0 t0.004
11: event end code="M30"
end of program: 11 blocks, 1 motions, 9 errors, 0 warnings

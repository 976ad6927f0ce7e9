=== about
Expressions and words that are none.
Truth: the place of each of the twelve faults, the length of line 12 (1 + 150 + 1), and that nothing moves.
proves: wl4-4.2-num
=== settings
control = wl4-mill
max_errors = 20
=== main
%S
G54
X(1+2
X
X#
IF #1 X2
#1 5
XFOO(1)
x5
X9999999
X(1/0)
X((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1
X1*
G200
M30
%
=== says
main.nc:3:2: error
main.nc:4:2: error
main.nc:5:3: error
main.nc:6:1: error
main.nc:7:1: error
main.nc:8:2: error
main.nc:9:1: error
main.nc:10:1: error
main.nc:11:1: error
main.nc:12:1: warning[wl4-long-block]: the block has 152 characters
main.nc:12:
main.nc:13:4: error
main.nc:14:1: error
14 blocks, 0 motions, 12 errors, 1 warnings
=== expect
file 0 main.nc
main.nc:3:2: error[wl4-syntax]: ')' is missing
    X(1+2
     ^~~~
main.nc:4:2: error[wl4-syntax]: a number, a variable, a function or a parenthesis is missing here
    X
     ^
main.nc:5:3: error[wl4-syntax]: the number of the variable is missing behind '#'
    X#
      ^
main.nc:6:1: error[wl4-syntax]: the condition is missing behind IF: IF(#1>#2)
    IF #1 X2
    ^~~
main.nc:7:1: error[wl4-syntax]: '=' is missing behind the variable
    #1 5
    ^~~
main.nc:8:2: error[wl4-syntax]: there is no function FOO
    XFOO(1)
     ^~~
main.nc:9:1: error[wl4-syntax]: addresses are capital letters
    x5
    ^
main.nc:10:1: error[wl4-syntax]: X: 9999999 is out of the range -19999.998 to 19999.998
    X9999999
    ^~~~~~~~
main.nc:11:1: error[wl4-syntax]: X: inf is out of the range -19999.998 to 19999.998
    X(1/0)
    ^~~~~~
main.nc:12:1: warning[wl4-long-block]: the block has 152 characters: the control takes 80
    X((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1
    ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
main.nc:12:102: error[wl4-syntax]: the expression is nested too deep
    X((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((1
                                                                                                         ^
main.nc:13:4: error[wl4-syntax]: a number, a variable, a function or a parenthesis is missing here
    X1*
       ^
main.nc:14:1: error[wl4-syntax]: there is no G200
    G200
    ^~~~
15: event end code="M30"
end of program: 14 blocks, 0 motions, 12 errors, 1 warnings

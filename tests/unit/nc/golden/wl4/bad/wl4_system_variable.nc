=== about
System variables can only be read; assignments of a bad block are taken back.
Truth: 9.2, #100 and up are read only and #400 to #999 are none; #1 is 5 still.
proves: wl4-4.2-var
=== settings
control = wl4-mill
max_errors = 9
=== main
%V
G54 #1=5
#1=7 #130=1
G0 X#1
X#999
M30
%
=== truth
rapid 5 0 0
=== says
main.nc:3:6: error
main.nc:5:2: error
5 blocks, 1 motions, 2 errors
=== expect
file 0 main.nc
main.nc:3:6: error[wl4-syntax]: #130 is a system variable: it can only be read
    #1=7 #130=1
         ^~~~~~
4: rapid from 0 0 0 to 5 0 0 t0.02
main.nc:5:2: error[wl4-syntax]: there is no variable #999
    X#999
     ^~~~
6: event end code="M30"
end of program: 5 blocks, 1 motions, 2 errors, 0 warnings

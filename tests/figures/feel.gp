# What a hand feels: gnuplot -c feel.gp STYLE feel.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 400)
set output ARG3
is(kind) = strcol("kind") eq kind
trace(which, value) = is("trace") && strcol("which") eq which ? value : NaN
rim(value) = is("rim") ? value : NaN

set multiplot
set label 1 "What a hand feels" at screen 0.5,0.95 center font "sans-serif,18" textcolor rgb ink
set tmargin at screen 0.80
set bmargin at screen 0.16
set datafile missing NaN

set lmargin at screen 0.075
set rmargin at screen 0.50
set xrange [0:159]
set yrange [-2.4:2.4]
set xlabel "ms" textcolor rgb ink
set ylabel "what trembles of a ball's force, mN" textcolor rgb ink
set label 2 "a scene's own force" at graph 0.02,1.06 textcolor rgb paper
set label 3 "at the hand, through 257 N/m" at graph 0.98,1.06 right textcolor rgb corrected
plot data using (trace("a scene's own", column("a"))):"b" with lines linecolor rgb paper linewidth 1, \
     data using (trace("at the hand", column("a"))):"b" with lines linecolor rgb corrected linewidth 2
unset label 2
unset label 3

set lmargin at screen 0.64
set rmargin at screen 0.97
set xrange [-22:10]
set yrange [-0.02:0.2]
set xlabel "ball's middle above the rim, mm" textcolor rgb ink
set ylabel "force, N" textcolor rgb ink offset 1,0
set label 4 "outwards" at -14,0.165 textcolor rgb corrected
set label 5 "up" at -1.5,0.030 textcolor rgb paper
set label 6 "over the rim's edge, 2 mm deep" at graph 0.5,1.06 center textcolor rgb ink
plot data using (rim(column("a"))):"b" with lines linecolor rgb corrected linewidth 2, \
     data using (rim(column("a"))):"c" with lines linecolor rgb paper linewidth 2
unset multiplot

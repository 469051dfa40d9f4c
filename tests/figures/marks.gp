# What carving leaves: gnuplot -c marks.gp STYLE marks.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 366)
set output ARG3
only(mark, value) = strcol("mark") eq mark ? value : NaN
clay = "#A8643C"

set multiplot
set label 1 "Marks that are not round" at screen 0.5,0.95 center font "sans-serif,18" textcolor rgb ink
set tmargin at screen 0.825
set bmargin at screen 0.175
set datafile missing NaN

# Level sections, with the lump's circle.
set size ratio -1
set parametric
set trange [0:2 * pi]
set xrange [-62:62]
set yrange [-62:62]
set xtics 30
set ytics 30
set xlabel "mm" textcolor rgb ink offset 0,0.6
set label 2 "eight facets, flat rib" at graph 0.5,1.07 center textcolor rgb ink
set lmargin at screen 0.06
set rmargin at screen 0.335
plot 55 * cos(t), 55 * sin(t) with lines linecolor rgb published dashtype 3 linewidth 1, \
     data using (only("facet", column("a_mm"))):"b_mm" with lines linecolor rgb clay linewidth 2
set label 2 "twelve flutes, loop trimmer" at graph 0.5,1.07 center textcolor rgb ink
set lmargin at screen 0.39
set rmargin at screen 0.665
plot 55 * cos(t), 55 * sin(t) with lines linecolor rgb published dashtype 3 linewidth 1, \
     data using (only("flute", column("a_mm"))):"b_mm" with lines linecolor rgb clay linewidth 2
unset parametric

# Upright sections of the outer face, five times as wide as high.
set size noratio
set xrange [51:56]
set xtics 2
set yrange [0:110]
set ytics 20
set label 2 "an incised line" at graph 0.5,1.07 center textcolor rgb ink
set lmargin at screen 0.73
set rmargin at screen 0.835
plot data using (only("incise", column("a_mm"))):"b_mm" with lines linecolor rgb clay linewidth 2
set label 2 "a trimmed foot" at graph 0.5,1.07 center textcolor rgb ink
set format y ""
set lmargin at screen 0.875
set rmargin at screen 0.98
plot data using (only("trim_foot", column("a_mm"))):"b_mm" with lines linecolor rgb clay linewidth 2
unset multiplot

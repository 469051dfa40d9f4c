# Edges with and without propagation: gnuplot -c edges.gp STYLE edges.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 400)
set output ARG3
of(what, with, value) = strcol("what") eq what && strcol("propagation") eq with ? value : NaN
clay = "#A8643C"
set datafile missing NaN
set key textcolor rgb ink

set multiplot
set label 1 "The edge of a groove" at screen 0.5,0.955 center font "sans-serif,18" textcolor rgb ink
set tmargin at screen 0.82
set bmargin at screen 0.17
set xlabel offset 0,0.4 textcolor rgb ink

# Without stretching, so that angles are what they are.
set size ratio -1
set lmargin at screen 0.07
set rmargin at screen 0.40
set label 2 "outline 4 mm deep, mm" at graph 0.5,1.07 center textcolor rgb ink
set xrange [44:64]
set yrange [23:49]
set xtics 5
set ytics 5
set xlabel "radius"
unset key
plot data using (of("outline", "without", column("x"))):"y" with lines title "without" linecolor rgb published linewidth 2, \
     data using (of("outline", "with", column("x"))):"y" with lines title "with" linecolor rgb clay linewidth 2

set size noratio
set lmargin at screen 0.46
set rmargin at screen 0.97
set label 2 "sharpest turn of the outline in 0.5 mm, degrees" at graph 0.5,1.07 center textcolor rgb ink
set xrange [0:6]
set yrange [0:60]
set xtics 1
set ytics 20
set xlabel "depth of the tool, mm"
set key on at graph 0.03,0.98 left top Left reverse samplen 1.5
plot data using (of("edge", "without", column("x"))):"y" with lines title "without propagation" linecolor rgb published linewidth 2, \
     data using (of("edge", "with", column("x"))):"y" with lines title "with" linecolor rgb clay linewidth 2
unset multiplot

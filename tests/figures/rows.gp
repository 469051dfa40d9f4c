# Rows that follow the clay: gnuplot -c rows.gp STYLE rows.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 430)
set output ARG3
clay = "#A8643C"
of(kind, what, value) = strcol("rows") eq kind && strcol("what") eq what ? value : NaN

set multiplot
set label 1 "The same pull on rows that only grow, and on rows that divide" \
    at screen 0.5,0.95 center font "sans-serif,18" textcolor rgb ink
set tmargin at screen 0.83
set bmargin at screen 0.16
set datafile missing NaN

# The wall along one ray, each row a bar with its edge.
set xrange [36:57]
set yrange [25:80]
set xtics 5
set ytics 10
set xlabel "radius, mm" textcolor rgb ink offset 0,0.5
set ylabel "height, mm" textcolor rgb ink offset 1,0
set label 2 "rows only grow" at graph 0.5,1.05 center textcolor rgb ink
set lmargin at screen 0.08
set rmargin at screen 0.33
plot data using (of("grow", "row", column("b"))):"a":(column("c")-column("b")):(0) \
       with vectors nohead linecolor rgb clay linewidth 1, \
     data using (of("grow", "row", column("c"))):"a" with fsteps linecolor rgb clay linewidth 2
set label 2 "rows divide" at graph 0.5,1.05 center textcolor rgb ink
set format y ""
unset ylabel
set lmargin at screen 0.37
set rmargin at screen 0.62
plot data using (of("divide", "row", column("b"))):"a":(column("c")-column("b")):(0) \
       with vectors nohead linecolor rgb clay linewidth 1, \
     data using (of("divide", "row", column("c"))):"a" with fsteps linecolor rgb clay linewidth 2

# The thickest row.
set format y "%g"
set logscale y
set xrange [0:16.5]
set yrange [0.3:6]
set xtics 5
set ytics (0.4, 0.8, 2, 4, 8)
set xlabel "time, s" textcolor rgb ink offset 0,0.5
set label 2 "the thickest row, mm" at graph 0.5,1.05 center textcolor rgb ink
set label 3 "twice the lump's" at 16.2,0.87 right textcolor rgb published
set lmargin at screen 0.70
set rmargin at screen 0.97
plot 0.8 with lines linecolor rgb published dashtype 3 linewidth 1, \
     data using (of("grow", "thickest", column("a"))):"b" with lines linecolor rgb published linewidth 2, \
     data using (of("divide", "thickest", column("a"))):"b" with lines linecolor rgb clay linewidth 2
unset multiplot

# The four bodies: gnuplot -c bodies.gp STYLE bodies.csv OUT.svg
load ARG1
data = ARG2
eval svg(1080, 510)
set output ARG3
set datafile missing NaN
names = "ball capsule box cylinder"
of(body, part, value) = (strcol("body") eq body && strcol("part") eq part) ? value : NaN
body_fill = "#CFE3F1"
bound = "#8A6D1F"
ray = "#D55E00"

set multiplot
set size ratio -1
unset grid
set border 0
unset xtics
unset ytics
left(k) = 0.005 + 0.2475 * k
do for [k=0:3] {
  name = word(names, k + 1)
  set lmargin at screen left(k)
  set rmargin at screen left(k) + 0.2425
  # From above: one row's plane.
  set tmargin at screen 0.93
  set bmargin at screen 0.49
  set xrange [29:83]
  set yrange [-23:23]
  unset label
  set label 1 name at graph 0.5,1.07 center font "sans-serif,16" textcolor rgb ink
  if (k == 0) {
    set label 2 "a ray, and\nits interval" at 30,19 textcolor rgb ray
    set label 3 "section with a row" at 56,-15.5 center textcolor rgb corrected
  }
  if (k == 2) { set label 2 "outline" at 69,-15 textcolor rgb bound }
  if (k == 0) {
  plot data using (of(name, "section", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb body_fill, \
       data using (of(name, "section", column("x_mm"))):"y_mm" with lines linecolor rgb corrected linewidth 1.6, \
       data using (of(name, "ray", column("x_mm"))):"y_mm" with lines linecolor rgb ray linewidth 1, \
       data using (of(name, "interval", column("x_mm"))):"y_mm" with linespoints linecolor rgb ray linewidth 3.5 pointtype 7 pointsize 0.5
  } else {
  plot data using (of(name, "section", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb body_fill, \
       data using (of(name, "section", column("x_mm"))):"y_mm" with lines linecolor rgb corrected linewidth 1.6, \
       data using (of(name, "outline", column("x_mm"))):"y_mm" with lines linecolor rgb bound dashtype 2 linewidth 1.4, \
       data using (of(name, "ray", column("x_mm"))):"y_mm" with lines linecolor rgb ray linewidth 1, \
       data using (of(name, "interval", column("x_mm"))):"y_mm" with linespoints linecolor rgb ray linewidth 3.5 pointtype 7 pointsize 0.5
  }
  # From the side.
  set tmargin at screen 0.455
  set bmargin at screen 0.015
  set yrange [27:73]
  unset label
  if (k == 0) {
    set label 2 "support point\none way" at 47,31.5 center textcolor rgb ink
  }
  if (k == 1) {
    set label 2 "heights" at 65,70.5 textcolor rgb bound
    set label 3 "hull of balls" at 62,32 textcolor rgb bound
  }
  if (k == 0) {
  plot data using (of(name, "silhouette", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb body_fill, \
       data using (of(name, "silhouette", column("x_mm"))):"y_mm" with lines linecolor rgb corrected linewidth 1.6, \
       data using (of(name, "support", column("x_mm"))):"y_mm":"radius_mm" with circles linecolor rgb ray linewidth 1.4 fillstyle empty, \
       data using (of(name, "towards", column("x_mm"))):"y_mm" with lines linecolor rgb ink linewidth 1.4, \
       data using (of(name, "point", column("x_mm"))):"y_mm" with points linecolor rgb ink pointtype 7 pointsize 0.6
  } else {
  plot data using (of(name, "silhouette", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb body_fill, \
       data using (of(name, "silhouette", column("x_mm"))):"y_mm" with lines linecolor rgb corrected linewidth 1.6, \
       data using (of(name, "heights", column("x_mm"))):"y_mm" with lines linecolor rgb bound dashtype 3 linewidth 1.2, \
       data using (of(name, "hull", column("x_mm"))):"y_mm":"radius_mm" with circles linecolor rgb bound linewidth 1.4 fillstyle empty, \
       data using (of(name, "support", column("x_mm"))):"y_mm":"radius_mm" with circles linecolor rgb ray linewidth 1.4 fillstyle empty, \
       data using (of(name, "towards", column("x_mm"))):"y_mm" with lines linecolor rgb ink linewidth 1.4, \
       data using (of(name, "point", column("x_mm"))):"y_mm" with points linecolor rgb ink pointtype 7 pointsize 0.6
  }
}
unset multiplot

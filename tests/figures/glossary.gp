# The house's own words: gnuplot -c glossary.gp STYLE glossary.csv OUT.svg
load ARG1
data = ARG2
eval svg(980, 460)
set output ARG3
only(part, value) = strcol("part") eq part ? value : NaN
clay = "#A8643C"
wall = "#F6EDE4"
looked = "#E6C9AE"
picked = "#E69F00"
tool = corrected
set datafile missing NaN
stats data using (only("figure", column("x_mm"))) name "FACE" nooutput
face = FACE_min
ball = 58.5
radius = 10.0

set multiplot
set size ratio -1
unset grid
set border 0
unset xtics
unset ytics
set style arrow 1 nohead linecolor rgb ink linewidth 1 dashtype 1
set style arrow 2 heads size 1.2,20 filled linecolor rgb ink linewidth 1.5 dashtype 1
set style arrow 3 nohead linecolor rgb ink linewidth 1 dashtype 3
set object 1 circle at ball,0 size radius front fillstyle transparent solid 0.2 border linecolor rgb tool

# Level: one row, seen from above.
set lmargin at screen 0.01
set rmargin at screen 0.5
set tmargin at screen 0.93
set bmargin at screen 0.01
set xrange [12:86]
set yrange [-31:31]
set label 1 "one row, from above" at graph 0.5,1.05 center font "sans-serif,16" textcolor rgb ink
sector = pi / 48
do for [k=0:1] {
  a = (k + 6.5) * sector
  set arrow 50 + k from 38 * cos(a),38 * sin(a) to 68 * cos(a),68 * sin(a) arrowstyle 3 front
}
set label 2 "sector" at 62.5,28.5 left textcolor rgb ink front
set label 3 "element: one\nsector of the row" at 66,21.5 textcolor rgb ink front
set arrow 20 from 65.5,20.5 to 52,17.5 arrowstyle 1 front
set label 4 "press: how deep\nthe tool is in it" at 12.5,1 textcolor rgb ink front
set arrow 21 from face,0 to ball - radius,0 arrowstyle 2 front
set arrow 22 from 29.5,0.3 to ball - radius - 0.3,0 arrowstyle 1 front
set label 5 "reach" at 70,-5 textcolor rgb ink front
set arrow 23 from ball,0 to ball + radius * cos(-0.45),radius * sin(-0.45) arrowstyle 2 front
set label 6 "extent: no outer face\nof the row lies beyond" at 62,-23 textcolor rgb ink front
set arrow 24 from 61.5,-22.5 to 55 * cos(-0.38),55 * sin(-0.38) arrowstyle 1 front
set label 7 "blocks of eight\nelements that\nare looked at" at 12.5,-16 textcolor rgb ink front
set arrow 25 from 30,-17 to 38.5,-14 arrowstyle 1 front
a = 2 * sector
off = ball * sin(a)
way = sqrt(radius * radius - off * off)
near = ball * cos(a) - way
far = ball * cos(a) + way
set arrow 30 from near * cos(a),near * sin(a) to far * cos(a),far * sin(a) arrowstyle 2 front
set arrow 31 from far * cos(a) + 0.5,far * sin(a) to 70,7.5 arrowstyle 1 front
set label 8 "interval, or span:\nof a ray in it" at 70.5,8.5 textcolor rgb ink front
plot data using (only("level", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb wall, \
     data using (only("level_looked", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb looked, \
     data using (only("level_element", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb picked, \
     data using (only("level", column("x_mm"))):"y_mm" with lines linecolor rgb clay linewidth 1.2, \
     data using (only("level_extent", column("x_mm"))):"y_mm" with lines linecolor rgb ink dashtype 2 linewidth 1.6

# Upright: the wall along the ball's ray.
unset label
unset arrow
set lmargin at screen 0.5
set rmargin at screen 0.99
set xrange [12:86]
set yrange [19:81]
set label 1 "the wall along one ray, upright" at graph 0.5,1.05 center font "sans-serif,16" textcolor rgb ink
set object 1 circle at ball,50 size radius front fillstyle transparent solid 0.2 border linecolor rgb tool
set label 2 "row" at 19,68.5 textcolor rgb ink front
set arrow 20 from 24,68.3 to 39.5,67.5 arrowstyle 1 front
set label 3 "its thickness" at 60,72.5 textcolor rgb ink front
set arrow 21 from 57.5,65 to 57.5,70 arrowstyle 2 front
set arrow 26 from 59.5,72 to 58,68.5 arrowstyle 1 front
set label 4 "press" at 19,53 textcolor rgb ink front
set arrow 22 from face,50.6 to ball - radius,50.6 arrowstyle 2 front
set arrow 23 from 26,52.8 to ball - radius - 0.3,50.7 arrowstyle 1 front
set label 5 "reach" at 70,45 textcolor rgb ink front
set arrow 24 from ball,50 to ball + radius * cos(-0.45),50 + radius * sin(-0.45) arrowstyle 2 front
set label 6 "extent of each row,\nall round the pot" at 62,28 textcolor rgb ink front
set arrow 25 from 61.5,28 to 55.3,30.5 arrowstyle 1 front
set label 7 "inner face" at 19,34 textcolor rgb ink front
set arrow 27 from 31.5,33.7 to 39.5,32.5 arrowstyle 1 front
set label 8 "outer face" at 62,36 textcolor rgb ink front
set arrow 28 from 61.5,36 to 55.3,37.5 arrowstyle 1 front
plot data using (only("upright", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb wall, \
     data using (only("upright_row", column("x_mm"))):"y_mm" with filledcurves closed fillcolor rgb picked, \
     data using (only("upright", column("x_mm"))):"y_mm" with lines linecolor rgb clay linewidth 1.2, \
     data using (only("extent", column("x_mm"))):"y_mm" with lines linecolor rgb ink dashtype 2 linewidth 1.6
unset multiplot

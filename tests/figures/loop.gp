# How stiff a wall a device bears: gnuplot -c loop.gp STYLE loop.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 560)
set output ARG3

set lmargin at screen 0.105
set rmargin at screen 0.83
set tmargin at screen 0.85
set bmargin at screen 0.12
set label 1 "How stiff a wall a device bears at 1 kHz" at screen 0.105,0.965 font "sans-serif,18" textcolor rgb ink
set logscale y
set xrange [-0.15:3.15]
set yrange [2:4000]
set xtics 1
set xlabel "ticks from a place to the force that it makes" textcolor rgb ink
set ylabel "stiffness, N/m" textcolor rgb ink
green = "#009E73"
of(b) = b < 0.3 ? paper : b < 0.7 ? corrected : green
# A colour is a device, a kind of line what is asked of it.
set label 2 "dashed: up to here a spring is passive; dots: what a device is given;" at screen 0.105,0.92 textcolor rgb published
set label 3 "triangles: stable behind the paper's filter" at screen 0.105,0.885 textcolor rgb published
set label 10 "the wheel head" at 3.2,501 textcolor rgb published
set label 11 "1.0 N s/m" at 3.2,232 textcolor rgb green
set label 12 "0.5 N s/m" at 3.2,116 textcolor rgb corrected
set label 13 "0.1 N s/m" at 3.2,23 textcolor rgb paper
is(b) = abs(column("damping") - b) < 0.01
plot data using "delay":"head" with lines linecolor rgb published dashtype 3 linewidth 1.5, \
     for [b in "0.1 0.5 1.0"] data using "delay":(is(b + 0) ? column("passive") : 1/0) with lines linecolor rgb of(b + 0) dashtype 2 linewidth 1.5, \
     for [b in "0.1 0.5 1.0"] data using "delay":(is(b + 0) ? column("given") : 1/0) with linespoints linecolor rgb of(b + 0) pointtype 7 pointsize 0.7 linewidth 2, \
     for [b in "0.1 0.5 1.0"] data using "delay":(is(b + 0) ? column("filtered") : 1/0) with points linecolor rgb of(b + 0) pointtype 8 pointsize 1 linewidth 1.5

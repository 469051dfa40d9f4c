# How stiff a wall a device bears: gnuplot -c loop.gp STYLE loop.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 560)
set output ARG3

set lmargin at screen 0.085
set rmargin at screen 0.70
set tmargin at screen 0.88
set bmargin at screen 0.12
set label 1 "How stiff a wall a device bears at 1 kHz" at screen 0.085,0.95 font "sans-serif,18" textcolor rgb ink
set logscale y
set xrange [-0.15:3.15]
set yrange [2:4000]
set xtics 1
set xlabel "ticks from a place to the force that it makes" textcolor rgb ink
set ylabel "stiffness, N/m" textcolor rgb ink
green = "#009E73"
of(b) = b < 0.3 ? paper : b < 0.7 ? corrected : green
# Each line is named at its end.
set label 10 "the wheel head under 0.5 N" at 3.2,501 textcolor rgb published
set label 11 "given, 1.0 N s/m" at 3.2,165 textcolor rgb green
set label 12 "a spring is passive" at 3.2,300 textcolor rgb green
set label 13 "given, 0.5 N s/m" at 3.2,92 textcolor rgb corrected
set label 14 "passive" at 3.2,143 textcolor rgb corrected offset 9,0
set label 15 "passive, 0.1 N s/m" at 3.2,31 textcolor rgb paper
set label 16 "given" at 3.2,18 textcolor rgb paper
set label 17 "stable behind the" at 3.2,6.8 textcolor rgb published
set label 18 "paper's 10 Hz filter" at 3.2,5 textcolor rgb published
is(b) = abs(column("damping") - b) < 0.01
plot data using "delay":"head" with lines linecolor rgb published dashtype 3 linewidth 1.5, \
     for [b in "0.1 0.5 1.0"] data using "delay":(is(b + 0) ? column("passive") : 1/0) with lines linecolor rgb of(b + 0) dashtype 2 linewidth 1.5, \
     for [b in "0.1 0.5 1.0"] data using "delay":(is(b + 0) ? column("given") : 1/0) with linespoints linecolor rgb of(b + 0) pointtype 7 pointsize 0.7 linewidth 2, \
     for [b in "0.1 0.5 1.0"] data using "delay":(is(b + 0) ? column("filtered") : 1/0) with points linecolor rgb of(b + 0) pointtype 8 pointsize 1 linewidth 1.5

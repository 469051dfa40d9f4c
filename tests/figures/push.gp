# Figure 8 of the paper, for both models: gnuplot -c push.gp STYLE push.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 1060)
set output ARG3

left = 0.105
right = 0.975
top(n) = 0.925 - 0.175 * n
surface_time = 1.8  # s: the sphere's centre crosses the pot's surface, 8 mm deep
turn_time = 1.2     # s: the first turn after the touch ends, and the tool meets its own groove

set multiplot
set lmargin at screen left
set rmargin at screen right
set xrange [0:2.6]
set xtics 0.2
set mxtics 1
set format x ""

# Title and legend above all panels.
set label 1 "A sphere is pushed slowly into the turning pot" at screen left,0.979 font "sans-serif,18" textcolor rgb ink
set label 2 "the equations as printed" at screen left + 0.045,0.951 textcolor rgb paper
set arrow 2 from screen left,0.951 to screen left + 0.037,0.951 nohead linecolor rgb paper linewidth 2
set label 3 "the corrected model" at screen left + 0.335,0.951 textcolor rgb corrected
set arrow 3 from screen left + 0.29,0.951 to screen left + 0.327,0.951 nohead linecolor rgb corrected linewidth 2

set arrow 10 from turn_time,graph 0 to turn_time,graph 1 nohead linecolor rgb published dashtype 3
set arrow 11 from surface_time,graph 0 to surface_time,graph 1 nohead linecolor rgb published dashtype 3

set tmargin at screen top(0)
set bmargin at screen top(0) - 0.148
set label 4 "elements in collision" at graph 0.012,0.93 textcolor rgb ink
set label 10 "the first turn ends" at turn_time - 0.02,graph 0.1 right textcolor rgb published
set label 11 "its centre passes the pot's surface" at surface_time + 0.02,graph 0.1 left textcolor rgb published
set yrange [0:1100]
set ytics 250
plot data using "time_s":"paper_touched" with lines linecolor rgb paper linewidth 1, \
     data using "time_s":"corrected_touched" with lines linecolor rgb corrected linewidth 1
unset label 1; unset label 2; unset label 3; unset arrow 2; unset arrow 3
unset label 10; unset label 11

set tmargin at screen top(1)
set bmargin at screen top(1) - 0.148
set label 4 "mean depth, mm"
set yrange [0:2.2]
set ytics 0.5
plot data using "time_s":"paper_mean_mm" with lines linecolor rgb paper linewidth 1, \
     data using "time_s":"corrected_mean_mm" with lines linecolor rgb corrected linewidth 1

set tmargin at screen top(2)
set bmargin at screen top(2) - 0.148
set label 4 "force, N"
set yrange [0:1.5]
set ytics 0.5
plot data using "time_s":"paper_force_N" with lines linecolor rgb paper linewidth 1.6, \
     data using "time_s":"corrected_force_N" with lines linecolor rgb corrected linewidth 1.6

set tmargin at screen top(3)
set bmargin at screen top(3) - 0.148
set label 4 "force after the 10 Hz filter, N"
plot data every 4 using "time_s":"paper_filtered_N" with lines linecolor rgb paper linewidth 1.6, \
     data every 4 using "time_s":"corrected_filtered_N" with lines linecolor rgb corrected linewidth 1.6

# Not in the paper: how far the unfiltered force jumps from one tick to the next.
set tmargin at screen top(4)
set bmargin at screen top(4) - 0.148
set label 4 "change of the unfiltered force in one tick, mN"
set yrange [-15:19]
set ytics 10
set format x "%.1f"
set xlabel "time, s" textcolor rgb ink offset 0,0.4
last = 0
change(f) = (d = f - last, last = f, 1000 * d)
plot last = 0, data using "time_s":(change(column("paper_force_N"))) with lines linecolor rgb paper linewidth 1, \
     last = 0, data using "time_s":(change(column("corrected_force_N"))) with lines linecolor rgb corrected linewidth 1
unset multiplot

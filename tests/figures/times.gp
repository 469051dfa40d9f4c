# Figure 7 of the paper, for both models: gnuplot -c times.gp STYLE times.csv OUT.svg
load ARG1
data = ARG2
eval svg(880, 560)
set output ARG3
machine = system(sprintf("sed -n 's/^# machine: //p' '%s'", data))

bottom = 0.195
set multiplot
set logscale y
set yrange [0.3:40000]
set ytics (1, 10, 100, "1 000" 1000, "10 000" 10000)
set tmargin at screen 0.815
set bmargin at screen bottom
left = 0.09

# Left: the paper's own picture.
set lmargin at screen left
set rmargin at screen 0.60
set label 1 "How long one tick takes" at screen left,0.955 font "sans-serif,18" textcolor rgb ink
set label 2 "the equations as printed" at screen left + 0.025,0.895 textcolor rgb paper
set label 3 "the corrected model" at screen left + 0.285,0.895 textcolor rgb corrected
set label 4 "published in 2009, drawing included" at screen left + 0.505,0.895 textcolor rgb published
set label 12 "" at screen left + 0.01,0.895 point pointtype 7 pointsize 0.9 linecolor rgb paper
set label 13 "" at screen left + 0.27,0.895 point pointtype 5 pointsize 0.9 linecolor rgb corrected
set label 14 "" at screen left + 0.49,0.895 point pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb published
set label 5 machine at screen 0.975,0.035 right font "sans-serif,11" textcolor rgb published
set label 6 "on the paper's four grids: mean and range" at graph 0.02,0.95 textcolor rgb ink
set label 7 "1 ms" at graph 0.015,first 1380 textcolor rgb ink
set arrow 1 from graph 0,first 1000 to graph 1,first 1000 nohead linecolor rgb ink linewidth 1.5 dashtype 2
set label 10 "µs" at graph -0.02,1.035 right textcolor rgb ink
set xlabel "rows × sectors" textcolor rgb ink offset 0,0.2
set xrange [-0.5:3.6]
set xtics ("200 × 180" 0, "200 × 360" 1, "400 × 360" 2, "800 × 360" 3)
set grid noxtics
set bars 0

grid_at(rows, sectors) = rows == 200 ? (sectors == 180 ? 0 : 1) : rows == 400 ? 2 : 3
all(model, shift) = strcol("model") eq model && strcol("distance_mm") eq "all" ? grid_at(column("rows"), column("sectors")) + shift : NaN
# The authors' own figures of 2009 at 400 x 360, ms a loop: the method of 2008, then the improved one.
$published << EOD
2.16,3930,930,8560
2.34,830,160,1990
EOD
set label 8 "2008's method" at first 2.26,9200 textcolor rgb published font "sans-serif,12"
set label 9 "improved" at first 2.42,1900 textcolor rgb published font "sans-serif,12"
plot data using (all("paper", -0.18)):"mean_us":"least_us":"most_us" with yerrorbars pointtype 7 pointsize 1 linewidth 5 linecolor rgb paper, \
     data using (all("corrected", 0)):"mean_us":"least_us":"most_us" with yerrorbars pointtype 5 pointsize 1 linewidth 5 linecolor rgb corrected, \
     $published using 1:2:3:4 with yerrorbars pointtype 6 pointsize 0.9 linewidth 1.5 linecolor rgb published
do for [n = 1:14] { unset label n }

# Right: where the range comes from.
set lmargin at screen 0.645
set rmargin at screen 0.975
set label 6 "at 400 × 360" at graph 0.03,0.95 textcolor rgb ink
set logscale x
set xrange [1.8:70]
set xtics (2, 4, 8, 16, 32, 60)
set ytics ("" 1, "" 10, "" 100, "" 1000, "" 10000)
set xlabel "tool's distance from the axis, mm"
near(model) = strcol("model") eq model && column("rows") == 400 && strcol("distance_mm") ne "all" ? column("distance_mm") : NaN
set label 7 "falls as 1 / distance" at first 13,first 190 textcolor rgb published font "sans-serif,12"
plot [1.8:70] 1600.0 / x with lines linecolor rgb published dashtype 3, \
     data using (near("paper")):"mean_us" with linespoints pointtype 7 pointsize 0.7 linewidth 1.8 linecolor rgb paper, \
     data using (near("corrected")):"mean_us" with linespoints pointtype 5 pointsize 0.7 linewidth 1.8 linecolor rgb corrected
unset multiplot

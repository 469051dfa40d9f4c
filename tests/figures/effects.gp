# What each effect does: gnuplot -c effects.gp STYLE effects.csv OUT.svg
load ARG1
data = ARG2
eval svg(1380, 620)
set output ARG3
of(effect, series, value) = strcol("effect") eq effect && strcol("series") eq series ? value : NaN
clay = "#A8643C"
water = "#0072B2"
set datafile missing NaN
set key top right samplen 1.5 font "sans-serif,11" textcolor rgb ink
set xlabel offset 0,0.5 font "sans-serif,12" textcolor rgb ink
set tics font "sans-serif,11"

set multiplot
left(n) = 0.038 + 0.164 * n
place = "set lmargin at screen left(%d); set rmargin at screen left(%d) + 0.121; set tmargin at screen %.3f; set bmargin at screen %.3f"
panel(n, low, words) = sprintf(place, n, n, low ? 0.40 : 0.90, low ? 0.10 : 0.60) . sprintf("; set title '%s' font 'sans-serif,13' textcolor rgb ink offset 0,-0.5", words)

eval panel(0, 0, "friction, N")
set xlabel "slip, m/s"
set xtics 0.04
plot data using (of("friction", "dry", column("x"))):"y" with lines title "dry" linecolor rgb clay linewidth 2, \
     data using (of("friction", "wet", column("x"))):"y" with lines title "wet" linecolor rgb water linewidth 2

eval panel(1, 0, "moisture")
set xlabel "s"
set xtics 40
set yrange [0:1.2]
plot data using (of("moisture", "beside the sponge", column("x"))):"y" with lines title "at the sponge" linecolor rgb water linewidth 2, \
     data using (of("moisture", "far from it", column("x"))):"y" with lines title "far from it" linecolor rgb clay linewidth 2
set yrange [*:*]

eval panel(2, 0, "walls and volume, pulled")
set xlabel "mm"
set xrange [0:75]
set xtics 25
set yrange [0:380]
plot data using (of("volume", "without", column("x"))):"y" with lines title "without" linecolor rgb published linewidth 2, \
     data using (of("volume", "with", column("x"))):"y" with lines title "with" linecolor rgb clay linewidth 2

eval panel(3, 0, "propagation, a groove")
set xlabel "mm"
set xrange [52:56.5]
set xtics 1
set yrange [80:136]
plot data using (of("propagation", "without", column("x"))):"y" with lines title "without" linecolor rgb published linewidth 2, \
     data using (of("propagation", "with", column("x"))):"y" with lines title "with" linecolor rgb clay linewidth 2

eval panel(0, 1, "springback, mm deep")
set xlabel "s (let go at 0.1 s)"
set xrange [0:2]
set xtics 1
set yrange [0:1.5]
plot data using (of("springback", "0 %", column("x"))):"y" with lines title "share 0" linecolor rgb published linewidth 2, \
     data using (of("springback", "15 %", column("x"))):"y" with lines title "0.15" linecolor rgb clay linewidth 2, \
     data using (of("springback", "40 %", column("x"))):"y" with lines title "0.4" linecolor rgb water linewidth 2
set yrange [*:*]

eval panel(1, 1, "smoothing, a line and a rib")
set xlabel "mm"
set xrange [53.5:56]
set yrange [60:165]
plot data using (of("smoothing", "before", column("x"))):"y" with lines title "before" linecolor rgb published linewidth 2, \
     data using (of("smoothing", "after", column("x"))):"y" with lines title "after" linecolor rgb clay linewidth 2

eval panel(2, 1, "wobble, mm off the middle")
set xlabel "s"
set xrange [0:12]
set xtics 4
set yrange [0:5.5]
plot data using (of("wobble", "left alone", column("x"))):"y" with lines title "left alone" linecolor rgb published linewidth 2, \
     data using (of("wobble", "pressed", column("x"))):"y" with lines title "pressed" linecolor rgb clay linewidth 2

eval panel(3, 1, "slump, cm high (5 kPa)")
set xlabel "s (25 cm is soaked at 20 s)"
set xrange [0:40]
set xtics 10
set yrange [0:110]
plot data using (of("slump", "60 cm", column("x"))):"y" with lines title "60 cm" linecolor rgb clay linewidth 2, \
     data using (of("slump", "50 cm", column("x"))):"y" with lines title "50 cm" linecolor rgb "#D8A98C" linewidth 2, \
     data using (of("slump", "45 cm", column("x"))):"y" with lines title "45 cm" linecolor rgb published linewidth 2, \
     data using (of("slump", "25 cm", column("x"))):"y" with lines title "25 cm" linecolor rgb water linewidth 2

eval panel(4, 0, "walls that tear, N felt")
set xlabel "mm, opened to"
set xrange [43:70]
set xtics 10
set yrange [0:0.34]
plot data using (of("tearing", "without", column("x"))):"y" with lines title "never" linecolor rgb published linewidth 2, \
     data using (of("tearing", "with", column("x"))):"y" with lines title "strain 0.3" linecolor rgb clay linewidth 2

eval panel(4, 1, "kiln, % of the size")
set xlabel "dried, then fired"
set xrange [0:2]
set xtics ("thrown" 0, "dry" 1, "fired" 2)
set yrange [80:104]
plot data using (of("kiln", "earthenware", column("x"))):"y" with lines title "earthenware" linecolor rgb clay linewidth 2, \
     data using (of("kiln", "stoneware", column("x"))):"y" with lines title "stoneware" linecolor rgb published linewidth 2, \
     data using (of("kiln", "porcelain", column("x"))):"y" with lines title "porcelain" linecolor rgb water linewidth 2
eval panel(5, 0, "building, five coils")
set xlabel "mm"
set xrange [40:60]
set xtics 10
set yrange [0:110]
plot data using (of("building", "laid", column("x"))):"y" with lines title "laid" linecolor rgb published linewidth 2, \
     data using (of("building", "pinched", column("x"))):"y" with lines title "pinched" linecolor rgb clay linewidth 2
eval panel(5, 1, "beating, five coils")
set xrange [40:65]
plot data using (of("beating", "laid", column("x"))):"y" with lines title "laid" linecolor rgb published linewidth 2, \
     data using (of("beating", "beaten", column("x"))):"y" with lines title "beaten" linecolor rgb clay linewidth 2
unset multiplot

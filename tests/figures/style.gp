# What all figures share. Okabe and Ito's colours, told apart by the colour-blind; the models also
# differ in weight or mark. `svg W H` in pixels.
paper = "#D55E00"
corrected = "#0072B2"
published = "#6B6B6B"
ink = "#222222"
faint = "#DDDDDD"
svg(w, h) = sprintf("set terminal svg size %d,%d noenhanced font 'sans-serif,14' background '#FFFFFF' linewidth 1", w, h)
set datafile separator ","
set datafile commentschars "#"
set border 3 linecolor rgb ink linewidth 1
set tics nomirror out scale 0.6 textcolor rgb ink
set grid linecolor rgb faint linewidth 1 linetype 1
unset key

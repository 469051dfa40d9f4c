#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/history.h"

namespace onggi::clay {

/// Dividing and joining rows of a stack. Nothing here allocates or knows the volume of a row:
/// effects/refinement.h decides when to call it.

/// Row `j` may be divided: there is a spare row, none of it is torn, and the floor would lie where
/// it may still.
bool may_divide(const Clay& clay, int j) noexcept;

/// Row `j` becomes two of equal height, which together hold `volume` (m^3): its lower and, over it,
/// its upper half. Their faces lie on the line through it and that neighbour above or below which
/// differs less (van Leer's MUSCL reconstruction of R^2, minmod), so that no radius is larger or
/// smaller than one that was there, and as much is added to one half's section as is taken from the
/// other's. The clay keeps areas, and knows those of both. Marks dirty; the caller restacks from
/// `j`. O(sectors), and O(rows above).
void divide_row(Clay& clay, int j, double volume) noexcept;

/// Rows `j` and `j` + 1 may be made one, as far as tears, the floor and hands go: neither is torn,
/// moved in this tick or marked in the clay's areas, and both are solid or neither.
bool may_join(const Clay& clay, int j) noexcept;

/// How far the outline of any sector would be from where it was were the two made one: m, over both
/// faces, at the rows' middles. O(sectors).
double join_error(const Clay& clay, int j) noexcept;

/// Rows `j` and `j` + 1, which together hold `volume` (m^3), become one, at `j`: every element has
/// the clay of both (the mean of R^2, by height), but for walls that would be thinner than
/// wall_min. As divide_row().
void join_rows(Clay& clay, int j, double volume) noexcept;

/// Before a fresh lump is laid: the stack has the lump's number of rows again, which come and go at
/// the top. `history` may be null. At most about `element_budget` elements a call; true when done.
bool restore_row_count(Clay& clay, History* history, int element_budget) noexcept;

}  // namespace onggi::clay

#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/history.h"

namespace onggi::clay {

/// Dividing and joining rows of a stack. Nothing here allocates or knows the volume of a row:
/// effects/refinement.h decides when to call it.

/// True if row `j` may be divided: a spare row is left, the row is not torn, and the floor stays in
/// place.
bool may_divide(const Clay& clay, int j) noexcept;

/// Divides row `j` into two of equal height, which together hold `volume` (m^3). Their faces lie on
/// the line through the row and the neighbour that differs less (van Leer's MUSCL reconstruction of
/// R^2, minmod): no new largest or smallest radius, and one half gains the area that the other
/// loses. The clay must keep areas, and knows both. Marks dirty; the caller restacks from `j`.
/// O(sectors), and O(rows above).
void divide_row(Clay& clay, int j, double volume) noexcept;

/// True if rows `j` and `j` + 1 may be joined: neither is torn, moved in this tick or marked in the
/// clay's areas, and both are solid or neither.
bool may_join(const Clay& clay, int j) noexcept;

/// How far joining the two would move the outline of any sector: m, over both faces, at the rows'
/// middles. O(sectors).
double join_error(const Clay& clay, int j) noexcept;

/// Joins rows `j` and `j` + 1, which together hold `volume` (m^3), at `j`: every element has the
/// clay of both (the mean of R^2, by height), but no wall gets thinner than wall_min. Otherwise as
/// divide_row().
void join_rows(Clay& clay, int j, double volume) noexcept;

/// Before a fresh lump: brings the stack back to the lump's number of rows, at the top. `history`
/// may be null. At most about `element_budget` elements a call; true when done.
bool restore_row_count(Clay& clay, History* history, int element_budget) noexcept;

}  // namespace onggi::clay

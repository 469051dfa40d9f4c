#pragma once

#include <string>

#include "kiosk/collection/decoration/decoration.h"

namespace onggi::decoration {

/// `value` m as a file can have it: to a ten thousandth of `unit`, 1e-3 or 1e-6 m. What is kept so
/// is read as the same bits.
double kept_length(double value, double unit);

/// A share, or a place round the pot, as a file can have it: to a millionth.
double kept_share(double value);

/// `decoration` as the text of a decoration.toml. read_decoration() of it gives the same steps,
/// pigments, colours and words, to the bit where lengths are kept_length() and colours those of a
/// file. Its motifs are motif_of()'s or read_motif()'s. A motif that comes again is written once.
/// Allocates.
std::string to_toml(const Decoration& decoration);

}  // namespace onggi::decoration

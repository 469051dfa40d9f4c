#pragma once

#include <span>
#include <string_view>

namespace onggi::lab {

/// A law of the clay against a witness: something that is not the engine. A closed form, a plain
/// sum, an equation solved by hand, a balance, a symmetry, a limiting case, written from the
/// equations in engine/docs and not from the engine's code.
struct Witness {
  std::string_view law;      ///< A name of its own: "press at speed".
  std::string_view against;  ///< The witness, in words.
  std::string_view altered;  ///< What measure() alters in the engine alone.
  double bound = 0.0;        ///< The law holds where they are apart by no more.
  std::string_view unit{};   ///< Of `bound`: "m", "N"; empty: a share.
  /// How far engine and witness are apart, >= 0, if the engine runs with `altered` off by the share
  /// `by` while the witness believes what stands in the scene. 0: the law itself. A witness that
  /// can fail is beyond its bound at 0.05. Up to a few seconds; allocates.
  double (*measure)(double by);

  /// NaN never holds.
  bool holds(double apart) const { return apart <= bound; }
};

/// The witnesses of one family of laws.
struct WitnessFamily {
  std::string_view name;  ///< "contact"
  std::span<const Witness> witnesses;
};
/// All of them, in the order of the pipeline's stages.
std::span<const WitnessFamily> witness_families();

/// Of each family, from a file of its own.
std::span<const Witness> contact_witnesses();
std::span<const Witness> effect_witnesses();
std::span<const Witness> wall_witnesses();
std::span<const Witness> building_witnesses();
std::span<const Witness> force_witnesses();
std::span<const Witness> clay_witnesses();

}  // namespace onggi::lab

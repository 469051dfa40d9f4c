#pragma once

namespace onggi::lab {

/// Convergence of three results on ever finer steps (Roache 1994).
struct Order {
  double p = 0.0;  ///< ln((coarse - middle) / (middle - fine)) / ln r; NaN if they do not converge
                   ///< from one side.
  double uncertainty = 0.0;  ///< 1.25 |middle - fine| / (r^p - 1), with the theory's p if p is NaN:
                             ///< error bound of the finest, in its own unit.
  double gci = 0.0;          ///< The same as a share of the finest: the grid-convergence index.
  bool asymptotic = false;   ///< p is within 0.3 of the theory's.
};

/// How far an order may be from the theory's.
inline constexpr double kOrderAllowed = 0.3;

/// For results on steps that are each `ratio` (> 1) times finer than the one before; `theory` > 0
/// is the expected order.
Order observed_order(double coarse, double middle, double fine, double ratio, double theory);

}  // namespace onggi::lab

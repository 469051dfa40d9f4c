#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace onggi {

/// A fault, in the three parts that a person needs to fix it. For content, configuration and
/// definitions; never on the 1 kHz tick.
struct Problem {
  std::string where;  ///< File, line, column, field or mesh: "config/exhibit.toml:12:3".
  std::string
      what;  ///< The meaning, as a sentence: "idle.warn_s is -5, and a wait cannot be negative."
  std::string remedy;  ///< What to do, as a sentence: "Write a number of seconds from 20 to 3600."
  int exit_code =
      2;  ///< 2: the input's fault; 1: the program's or the machine's (disk full, no GL).
};

/// A value, or the Problem that prevented it. Allocates only for the Problem.
template <class T>
using Result = tl::expected<T, Problem>;

/// Shorthand for returning a Problem from a function that returns a Result.
inline tl::unexpected<Problem> problem(std::string where, std::string what, std::string remedy,
                                       int exit_code = 2) {
  return tl::unexpected<Problem>(
      Problem{std::move(where), std::move(what), std::move(remedy), exit_code});
}

/// "where: what\nremedy": the one printed form of a Problem.
std::string to_text(const Problem& p);

}  // namespace onggi

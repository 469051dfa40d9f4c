#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/profile/profile.h"

namespace onggi::score {

/// How hard a vessel is to throw, by its shape alone: how far its wall leans where it leans most
/// (0 upright .. 1 level: a shoulder), and more if it is lower than wide. About 0.4 for a cylinder,
/// 1.1 for a flat bowl. Only the order means something (kiosk/docs/score.md has it beside what
/// beginners reach). The same bits on every machine; `vessel` is valid.
double hardness(const Profile& vessel);

/// Of `among`, the vessel that comes next after `of` in hardness, or before it if not `harder`;
/// none if there is none. Null and `of` itself are skipped.
std::optional<std::size_t> next_in_hardness(const Profile& of, bool harder,
                                            std::span<const Profile* const> among);

}  // namespace onggi::score

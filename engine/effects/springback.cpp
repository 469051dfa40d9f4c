#include "engine/effects/springback.h"

#include <algorithm>

#include "engine/effects/effect_list.h"
#include "engine/effects/row_kernels.h"
#include "engine/math/portable.h"

namespace onggi {
namespace {

constexpr double kTurns = 8.0;  // turns per row in SpringbackDef::time: few, so that each step is
                                // well above a float's digits

}  // namespace

std::span<const DefField<SpringbackDef>> SpringbackDef::fields() {
  static constexpr DefField<SpringbackDef> kFields[] = {
      {"share", &SpringbackDef::share, 0.0, 0.5, ""},
      {"time", &SpringbackDef::time, 0.01, 10.0, "s"},
  };
  return kFields;
}

namespace effects {

Springback::Springback(const Clay& clay)
    : stride_(static_cast<std::size_t>(clay.stride())),
      room_(static_cast<std::size_t>(clay.room())) {
  for (Face& face : face_) {
    face.left.resize(room_ * stride_);
    face.seen.resize(room_);
    face.rows.resize(room_);
  }
}

bool Springback::wanted(const Effects& def) { return def.springback.has_value(); }

void Springback::run(const StageWork& work) noexcept {
  load(*work.def.springback, work.clay, work.side);
  come_back(*work.def.springback, work.clay, work.tick.seconds, work.def.walls ? 1.0 : 0.0);
}

void Springback::load(const SpringbackDef& def, Clay& clay, WallSide side) noexcept {
  Displacements& displacements = *clay.displacements(side == WallSide::inside);
  if (!displacements.any()) return;
  Face& f = face(side);
  const auto share = static_cast<float>(def.share);
  const int first = displacements.first_row();
  const int end = displacements.end_row();
  for (BlockRun run = displacements.run_from(0); run.any(); run = displacements.run_from(run.end)) {
    const int begin = run.begin * Displacements::kBlock;
    const int elements = run.end * Displacements::kBlock - begin;
    for (int j = first; j < end; ++j) {
      const int stored = clay.stored(j);
      const float* const moved = displacements.row(stored) + begin;
      float* const left = f.left.data() + static_cast<std::size_t>(stored) * stride_ + begin;
      for (int i = 0; i < elements; ++i) left[i] += share * moved[i];
    }
  }
  for (int j = first; j < end; ++j) {
    const auto n = static_cast<std::size_t>(clay.stored(j));
    if (f.rows[n] != 0) continue;
    f.rows[n] = 1;
    f.seen[n] = now_;
    ++loaded_rows_;
  }
}

void Springback::row_back(Clay& clay, WallSide side, int j, double time, double along) noexcept {
  Face& f = face(side);
  const int stored = clay.stored(j);
  const auto n = static_cast<std::size_t>(stored);
  row_kernels::Spring how;
  how.gone = static_cast<float>(-portable::expm1(-(now_ - f.seen[n]) / time));
  how.least = kLeastMove;  // the last bit comes back at once, so that resting clay rests
  f.seen[n] = now_;
  float* const left = f.left.data() + n * stride_;
  float most = 0.0f;
  if (may_move(clay, side, j, along, how.face)) {
    const bool outside = side == WallSide::outside;
    float* const outer = clay.stored_outer(stored);
    float* const inner = clay.stored_inner(stored);
    const row_kernels::Sprung sprung =
        row_kernels::of(clay.vectors())
            .spring(how, clay.stride(), left, outside ? outer : inner, outside ? inner : outer);
    was_moved(clay, j, sprung.moved);
    most = sprung.left;
  } else {
    // Clay that no longer yields still forgets its load.
    for (std::size_t i = 0; i < stride_; ++i) {
      left[i] -= left[i] < how.least ? left[i] : left[i] * how.gone;
      most = std::max(most, left[i]);
    }
  }
  if (most > 0.0f) return;
  f.rows[n] = 0;
  --loaded_rows_;
}

void Springback::come_back(const SpringbackDef& def, Clay& clay, double seconds,
                           double along) noexcept {
  if (asleep()) return;
  now_ += seconds;
  // Turns go by the clock, not by the number of loaded rows. So a grid twice as fine has its turns
  // at the same heights and times. A tick longer than a round brings a row one turn.
  for (double left = seconds; left > 0.0;) {
    if (round_.over()) {
      round_.begin();
      next_ = 0;
      whole_ = Round::lasting(def.time / kTurns, 1.0 * loaded_rows_ * static_cast<double>(stride_));
      left = std::min(left, whole_);
    }
    const int till = round_.go_on(left, whole_, clay.rows());
    for (; next_ < till; ++next_)
      for (const WallSide side : {WallSide::outside, WallSide::inside})
        if (face(side).rows[static_cast<std::size_t>(clay.stored(next_))] != 0)
          row_back(clay, side, next_, def.time, along);
  }
  if (asleep()) round_.stop();
}

void Springback::row_divided(const Clay&, const RowDivided& divided) noexcept {
  for (Face& f : face_) {
    const auto a = static_cast<std::size_t>(divided.from);
    const auto b = static_cast<std::size_t>(divided.to);
    if (f.rows[a] == 0) continue;
    std::copy_n(f.left.begin() + static_cast<std::ptrdiff_t>(a * stride_), stride_,
                f.left.begin() + static_cast<std::ptrdiff_t>(b * stride_));
    f.seen[b] = f.seen[a];
    f.rows[b] = 1;
    ++loaded_rows_;
  }
}

void Springback::forget(Clay&, const Laid&) noexcept {
  for (Face& f : face_)
    for (std::size_t n = 0; n < f.rows.size(); ++n) {
      if (f.rows[n] == 0) continue;
      std::fill_n(f.left.begin() + static_cast<std::ptrdiff_t>(n * stride_), stride_, 0.0f);
      f.rows[n] = 0;
    }
  loaded_rows_ = 0;
  round_.stop();
}

void Springback::add_to(StateHash& hash, Clay&) const {
  for (const Face& f : face_) {
    for (std::size_t n = 0; n < f.rows.size(); ++n) {
      if (f.rows[n] == 0) continue;
      hash.add(static_cast<std::uint64_t>(n));
      hash.add(f.seen[n]);
      hash.add(std::span(f.left).subspan(n * stride_, stride_));
    }
  }
  hash.add(static_cast<std::uint64_t>(next_));
  hash.add(now_);
  hash.add(whole_);
  round_.add_to(hash);
}

}  // namespace effects
}  // namespace onggi

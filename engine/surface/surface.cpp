#include "engine/surface/surface.h"

#include <algorithm>
#include <utility>

namespace onggi::surface {

Surface::Surface(std::vector<Row> outline)
    : outline_(std::move(outline)),
      relief_(rows(), kSectors),
      slip_(rows(), kSectors),
      glaze_(rows(), kSectors),
      skin_(rows(), kSectors),
      smoke_(rows(), kSectors),
      rests_(rows(), kRests) {}

Result<Surface> Surface::create(const Profile& profile, const std::string& name) {
  Result<std::vector<Row>> outline = outline_of(profile, name);
  if (!outline) return tl::unexpected<Problem>(outline.error());
  return Surface(std::move(*outline));
}

void Surface::set_relief(int j, int i, int um) {
  relief_.set(j, i, static_cast<std::int16_t>(std::clamp(um, kLeastRelief, kMostRelief)));
}
void Surface::set_glaze(int j, int i, int units) {
  glaze_.set(j, i, static_cast<std::uint8_t>(std::clamp(units, 0, kMostGlaze)));
}
void Surface::set_resist(int j, int i, bool covered) {
  const int others = skin_.at(j, i) & ~kResist;
  skin_.set(j, i, static_cast<std::uint8_t>(covered ? others | kResist : others));
}
void Surface::set_coil(int j, int i, bool laid) {
  const int others = skin_.at(j, i) & ~kCoil;
  skin_.set(j, i, static_cast<std::uint8_t>(laid ? others | kCoil : others));
}
void Surface::set_burnish(int j, int i, int passes) {
  const int others = skin_.at(j, i) & ~kBurnish;
  skin_.set(j, i, static_cast<std::uint8_t>(others | std::clamp(passes, 0, kMostBurnish)));
}
void Surface::set_smoke(int j, int i, int carbon) {
  smoke_.set(j, i, static_cast<std::uint8_t>(std::clamp(carbon, 0, kMostSmoke)));
}

void Surface::begin_step(bool continues) {
  if (continues && steps_ > 0) return;
  end_step();
  while (steps_ > 0 && (steps_ >= kMostSteps || undo_bytes() > kUndoBytes)) {
    each_layer(*this, [](auto& layer) { layer.forget_oldest(); });
    --steps_;
  }
  each_layer(*this, [](auto& layer) { layer.begin_step(); });
  ++steps_;
}

void Surface::end_step() {
  each_layer(*this, [](auto& layer) { layer.settle(); });
}

void Surface::undo() {
  if (steps_ == 0) return;
  each_layer(*this, [](auto& layer) { layer.undo(); });
  --steps_;
}

Volume Surface::slip_volume(int pigment) const {
  Volume sum = 0;
  for (int j = 0; j < rows(); ++j) {
    Volume thickness = 0;  // of all the row's cells
    for (int i = 0; i < kSectors; ++i) {
      const Strata strata = slip(j, i);
      if (strata.word() == 0) continue;
      for (int k = 0; k < kStrata; ++k)
        if (strata.at(k).pigment == pigment) thickness += thickness_of(strata.at(k).code);
    }
    sum += thickness * row(j).area + rest(j, pigment);
  }
  return sum;
}

Volume Surface::glaze_volume() const {
  Volume sum = 0;
  for (int j = 0; j < rows(); ++j) {
    Volume units = 0;
    for (int i = 0; i < kSectors; ++i) units += glaze(j, i);
    sum += units * kGlazeUnit * row(j).area + rest(j, kGlazeRest);
  }
  return sum;
}

std::size_t Surface::bytes() const {
  std::size_t sum = outline_.capacity() * sizeof(Row);
  each_layer(*this, [&](const auto& layer) { sum += layer.bytes(); });
  return sum;
}

std::size_t Surface::undo_bytes() const {
  std::size_t sum = 0;
  each_layer(*this, [&](const auto& layer) { sum += layer.kept_bytes(); });
  return sum;
}

std::uint64_t Surface::hash() const {
  StateHash hash;
  for (const Row& row : outline_) {
    hash.add(row.height), hash.add(row.radius);
    hash.add(static_cast<std::uint64_t>(row.wall));
  }
  each_layer(*this, [&](const auto& layer) { layer.add_to(hash); });
  return hash.value();
}

}  // namespace onggi::surface

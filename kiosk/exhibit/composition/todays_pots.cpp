#include "kiosk/exhibit/composition/todays_pots.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "kiosk/collection/content/texture_file.h"

namespace onggi::exhibit {

namespace {

/// 0 at a picture's edge .. 1 from a tenth of its width on: the picture's plaster blends into the
/// page's.
double cover(int at, int size, int width) {
  const double in = std::min(1.0, (std::min(at, size - 1 - at) + 0.5) / (0.1 * width));
  return in * in * (3 - 2 * in);
}

view::Image image_of(const textures::TexturePixels& pixels) {
  view::Image image{pixels.width, pixels.height, {}};
  image.rgba.reserve(pixels.rgb.size() / 3 * 4);
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x) {
      const std::size_t i =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels.width) +
               static_cast<std::size_t>(x));
      const double alpha =
          cover(x, pixels.width, pixels.width) * cover(y, pixels.height, pixels.width);
      image.rgba.insert(image.rgba.end(), {pixels.rgb[i], pixels.rgb[i + 1], pixels.rgb[i + 2],
                                           static_cast<std::uint8_t>(std::lround(255 * alpha))});
    }
  return image;
}

/// Reads all pictures at once; if the helper fails, one by one.
std::vector<std::optional<view::Image>> decoded(const TodaysPots::Encoded& pictures,
                                                const TodaysPots::Reader& read) {
  std::vector<std::optional<view::Image>> out(pictures.size());
  if (pictures.empty()) return out;
  const auto all = read(pictures);
  if (!all && pictures.size() == 1) return out;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (!all)
      out[i] = decoded({pictures[i]}, read).front();
    else if ((*all)[i])
      out[i] = image_of(*(*all)[i]);
  }
  return out;
}

}  // namespace

Result<std::vector<textures::Decoded>> TodaysPots::by_helper(const Encoded& pictures) {
  return content::read_textures(pictures, {});
}

TodaysPots::~TodaysPots() {
  if (finding_.valid()) finding_.wait();
}

TodaysPots::Found TodaysPots::find(const std::filesystem::path& folder, std::time_t now,
                                   const std::vector<std::string>& known, const Reader& read) {
  Found found;
  found.pots = souvenir::pots_of_today(folder, now, kMost);
  std::vector<std::string> keys;
  std::vector<files::Bytes> bytes;
  for (const souvenir::KeptPot& pot : found.pots) {
    if (std::find(known.begin(), known.end(), key_of(pot)) != known.end()) continue;
    auto picture = souvenir::picture_of(folder, pot);
    keys.push_back(key_of(pot));
    bytes.push_back(picture ? std::move(*picture) : files::Bytes());
  }
  const auto pictures = decoded({bytes.begin(), bytes.end()}, read);
  for (std::size_t i = 0; i < keys.size(); ++i)
    found.pictures[keys[i]] = pictures[i].value_or(view::Image{});
  return found;
}

void TodaysPots::look(double now, render::Renderer& renderer, bool wait) {
  if (!finding_.valid() && now - looked_at_ >= kLook) {
    looked_at_ = now;
    std::vector<std::string> known;
    for (const auto& [key, picture] : pictures_) known.push_back(key);
    for (const auto& [key, image] : to_be_shown_) known.push_back(key);
    finding_ = std::async(std::launch::async, find, folder_, wall_(), std::move(known), read_);
  }
  if (finding_.valid() &&
      (wait || finding_.wait_for(std::chrono::seconds(0)) == std::future_status::ready))
    take(finding_.get(), renderer);
  while (!to_be_shown_.empty()) {
    auto& [key, image] = to_be_shown_.front();
    pictures_[key] = image.width > 0 ? renderer.make_picture(image) : 0;
    to_be_shown_.pop_front();
    show();
    if (!wait) return;
  }
}

void TodaysPots::take(Found found, render::Renderer& renderer) {
  kept_ = std::move(found.pots);
  for (auto& [key, image] : found.pictures) to_be_shown_.emplace_back(key, std::move(image));
  const auto is_kept = [&](const std::string& key) {
    return std::any_of(kept_.begin(), kept_.end(),
                       [&](const souvenir::KeptPot& pot) { return key_of(pot) == key; });
  };
  std::erase_if(to_be_shown_, [&](const auto& one) { return !is_kept(one.first); });
  std::erase_if(pictures_, [&](const auto& one) {
    if (is_kept(one.first)) return false;
    if (one.second != 0) renderer.drop_picture(one.second);
    return true;
  });
  show();
}

void TodaysPots::show() {
  pots_.clear();
  for (const souvenir::KeptPot& pot : kept_)
    if (const auto found = pictures_.find(key_of(pot)); found != pictures_.end() && found->second)
      pots_.push_back({found->second, pot.vessel, pot.stars, pot.visit});
}

}  // namespace onggi::exhibit

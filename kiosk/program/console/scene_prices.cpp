#include "kiosk/program/console/scene_prices.h"

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/math/hash.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/toml/toml_text.h"
#include "kiosk/program/console/kept_files.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargest = 1u << 16;  // bytes: two dozen effects and options

bool has_prices(const std::string& json) {
  const auto read = nlohmann::json::parse(json, nullptr, false);
  return read.is_object() && read.contains("whole_us");
}

}  // namespace

fs::path ScenePrices::kept_in(const std::string& text) const {
  static const std::string kMachine = tuning::machine_name();
  StateHash hash;
  for (const std::string& words : {kMachine, text})
    for (const char c : words) hash.add(std::uint64_t{static_cast<unsigned char>(c)});
  char name[32];
  std::snprintf(name, sizeof name, "%016llx.json", static_cast<unsigned long long>(hash.value()));
  return folder_ / name;
}

void ScenePrices::take() {
  const auto said = measuring_.take();
  if (!said) return;
  const auto now = toml::read_toml_text(file_);
  if (!now || *now != text_) return;  // it changed meanwhile, so they may be another's
  if (!has_prices(*said)) {
    failed_text_ = text_;
    const auto report = nlohmann::json::parse(*said, nullptr, false);
    trouble_ = report.is_object() ? report.value("what", std::string()) : std::string();
    if (trouble_.empty()) trouble_ = "It could not be measured.";
    return;
  }
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (auto put = files::write_durably(kept_in(text_), std::as_bytes(std::span(*said))); !put) {
    failed_text_ = text_;
    trouble_ = to_text(put.error());
    return;
  }
  keep_newest(folder_, kKept);
}

std::optional<std::string> ScenePrices::of(const fs::path& file, const std::string& text,
                                           bool wanted) {
  take();
  if (const auto bytes = files::read_file(kept_in(text), kLargest)) {
    std::string json(bytes->begin(), bytes->end());
    if (has_prices(json)) return json;
  }
  if (wanted && failed_text_ != text &&
      measuring_.begin({"lab", "prices", "--json", "-", "--idle", file.string()})) {
    file_ = file;
    text_ = text;
  }
  return std::nullopt;
}

void ScenePrices::forget(const std::string& text) {
  std::error_code gone;
  fs::remove(kept_in(text), gone);
  if (failed_text_ == text) failed_text_.clear();
}

std::string ScenePrices::trouble(const std::string& text) const {
  return failed_text_ == text ? trouble_ : "";
}

}  // namespace onggi::console

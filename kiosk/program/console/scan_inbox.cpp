#include "kiosk/program/console/scan_inbox.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "kiosk/collection/archives/entry_names.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/web/received_file.h"
#include "kiosk/program/console/said.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::Json;

constexpr std::size_t kDeepest = 16;  // folders within folders

web::Answer another_scan() {
  return refused(503, "Another scan is on its way to the shelf.", "Try again in a moment.");
}

}  // namespace

ScanInbox::ScanInbox(fs::path onggi, fs::path folder)
    : onggi_(std::move(onggi)), folder_(std::move(folder)), scan_(folder_ / "scan") {
  std::error_code gone;
  fs::remove_all(scan_, gone);
  web::remove_abandoned(folder_);
}

web::BodyPlace ScanInbox::place_for_file() {
  take_answer();
  if (doing_ != Doing::nothing || !arriving_.expired()) return another_scan();
  std::error_code failed;
  fs::create_directories(folder_, failed);
  auto ticket = std::make_shared<int>();
  arriving_ = ticket;
  return web::IntoFile{.folder = folder_, .most = kMost, .ticket = std::move(ticket)};
}

Result<void> ScanInbox::take(web::ReceivedFile& file, const std::string& name, bool first) {
  take_answer();
  if (doing_ != Doing::nothing)
    return problem(name, "Another scan is on its way to the shelf.", "Try again in a moment.");
  if (files_ == kMostFiles && !first)
    return problem(name, "These are too many files.", "Send them as one zip archive.");
  if (auto good = archives::EntryNames("the scan", kDeepest).check(name); !good) return good;
  if (name.ends_with('/')) return problem(name, "This is a folder.", "Send the files in it.");
  if (first || files_ == 0) {
    forget();
    ++number_;
    name_ = name;
  }
  const fs::path to = scan_ / name;
  std::error_code failed;
  fs::create_directories(to.parent_path(), failed);
  const std::uint64_t size = file.size();
  if (auto moved = file.move_to(to); !moved) return moved;
  ++files_;
  bytes_ += size;
  found_.clear();
  placed_.clear();
  return {};
}

bool ScanInbox::look() {
  take_answer();
  if (doing_ != Doing::nothing || files_ == 0 ||
      !onggi_.begin({"vessel", "look", "--json", "-", scan_.string()}))
    return false;
  doing_ = Doing::looking;
  found_.clear();
  return true;
}

bool ScanInbox::put_on_shelf(const Choice& choice, const fs::path& shelf) {
  take_answer();
  const auto found = nlohmann::json::parse(found_, nullptr, false);
  if (doing_ != Doing::nothing || !found.is_object() || !found.contains("vessels") ||
      choice.vessel >= found["vessels"].size())
    return false;
  const auto& vessel = found["vessels"][choice.vessel];
  std::vector<std::string> arguments{"vessel",  "import",      "--json", "-", "--id=" + choice.id,
                                     "--shelf", shelf.string()};
  if (const std::string node = vessel.value("node", ""); !node.empty())
    arguments.push_back("--node=" + node);
  if (choice.turned_over) arguments.push_back("--up=" + vessel.value("down_axis", ""));
  if (choice.height_mm > 0.0) arguments.push_back("--height=" + std::to_string(choice.height_mm));
  arguments.push_back(vessel.value("file", ""));
  if (!onggi_.begin(std::move(arguments))) return false;
  doing_ = Doing::placing;
  placed_.clear();
  id_ = choice.id;
  return true;
}

bool ScanInbox::forget() {
  take_answer();
  if (doing_ != Doing::nothing) return false;
  std::error_code gone;
  fs::remove_all(scan_, gone);
  files_ = 0;
  bytes_ = 0;
  found_.clear();
  placed_.clear();
  return true;
}

void ScanInbox::take_answer() {
  auto said = onggi_.take();
  if (!said) return;
  const Doing done = std::exchange(doing_, Doing::nothing);
  if (done == Doing::looking) {
    found_ = std::move(*said);
    return;
  }
  if (nlohmann::json::parse(*said, nullptr, false).value("done", false)) {
    forget();
    put_ = id_;
  }
  placed_ = std::move(*said);
}

std::string ScanInbox::json() {
  take_answer();
  std::error_code none;
  const fs::space_info space = fs::space(folder_.parent_path(), none);
  const char* const doing = doing_ == Doing::looking   ? "looking"
                            : doing_ == Doing::placing ? "placing"
                                                       : "";
  Json out = Json::object({{"scan", number_},
                           {"name", name_},
                           {"files", files_},
                           {"bytes", bytes_},
                           {"most", kMost},
                           {"free", none ? 0 : space.available},
                           {"doing", doing},
                           {"id", id_}});
  std::string all = out.text(-1);
  all.insert(all.size() - 1, ",\"found\":" + (found_.empty() ? "null" : found_) +
                                 ",\"placed\":" + (placed_.empty() ? "null" : placed_));
  return all;
}

std::optional<std::string> ScanInbox::put() {
  take_answer();
  return std::exchange(put_, std::nullopt);
}

}  // namespace onggi::console

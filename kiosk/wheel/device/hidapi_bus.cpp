#include "kiosk/wheel/device/hidapi_bus.h"

#include <hidapi/hidapi.h>

#include <algorithm>
#include <cwchar>

namespace onggi::device {

namespace {

/// As UTF-8, without control characters.
std::string text_of(const wchar_t* wide) {
  std::string out;
  for (; wide != nullptr && *wide != L'\0' && out.size() < 120; ++wide) {
    const auto c = static_cast<char32_t>(*wide);
    if (c < 0x20 || c == 0x7f) continue;
    if (c < 0x80) {
      out += static_cast<char>(c);
    } else if (c < 0x800) {
      out += static_cast<char>(0xc0 | c >> 6);
      out += static_cast<char>(0x80 | (c & 0x3f));
    } else if (c < 0x10000 && (c < 0xd800 || c > 0xdfff)) {
      out += static_cast<char>(0xe0 | c >> 12);
      out += static_cast<char>(0x80 | (c >> 6 & 0x3f));
      out += static_cast<char>(0x80 | (c & 0x3f));
    } else {
      out += '?';
    }
  }
  return out;
}

class HidapiPort final : public HidPort {
 public:
  explicit HidapiPort(hid_device* handle) : handle_(handle) {}
  ~HidapiPort() override { hid_close(handle_); }
  HidapiPort(const HidapiPort&) = delete;
  HidapiPort& operator=(const HidapiPort&) = delete;
  int read(std::span<std::uint8_t> into, int timeout_ms) noexcept override {
    return hid_read_timeout(handle_, into.data(), into.size(), timeout_ms);
  }
  bool write(Report report) noexcept override {
    return hid_write(handle_, report.data(), report.size()) >= 0;
  }
  int feature(std::uint8_t id, std::span<std::uint8_t> into) noexcept override {
    if (into.empty()) return -1;
    into[0] = id;
    return hid_get_feature_report(handle_, into.data(), into.size());
  }

 private:
  hid_device* handle_;
};

class HidapiBus final : public HidBus {
 public:
  HidapiBus() { hid_init(); }
  // hid_exit() is not called: a port may outlive the bus, and the end of the process frees the
  // rest.
  std::vector<HidListing> list() override {
    std::vector<HidListing> all;
    hid_device_info* const first = hid_enumerate(0, 0);
    for (const hid_device_info* info = first; info != nullptr; info = info->next) {
      if (info->path == nullptr) continue;
      all.push_back({info->path, info->vendor_id, info->product_id, info->usage_page, info->usage,
                     info->bus_type == HID_API_BUS_BLUETOOTH, text_of(info->product_string),
                     text_of(info->serial_number)});
    }
    hid_free_enumeration(first);
    return all;
  }
  std::unique_ptr<HidPort> open(const std::string& path) override {
    hid_device* const handle = hid_open_path(path.c_str());
    return handle == nullptr ? nullptr : std::make_unique<HidapiPort>(handle);
  }
};

}  // namespace

std::unique_ptr<HidBus> hidapi_bus() { return std::make_unique<HidapiBus>(); }

}  // namespace onggi::device

// The symbols of hidapi 0.13 over a simulated world: preloaded, the real program finds these
// devices. ONGGI_STAND_IN names the scenario; without it nothing is plugged in.
#pragma GCC visibility push(default)
#include <hidapi/hidapi.h>
#pragma GCC visibility pop

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "tests/stand_in/world.h"

using onggi::stand_in::World;

namespace {

World& world() {
  // Never taken down: threads may read until the very end.
  static World* const made = [] {
    const char* file = std::getenv("ONGGI_STAND_IN");
    if (file == nullptr) return new World;
    try {
      return World::read(file).release();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "stand-in for hidapi: %s\n", error.what());
      std::_Exit(2);
    }
  }();
  return *made;
}

wchar_t* wide(const std::string& text) {
  auto* out = static_cast<wchar_t*>(std::calloc(text.size() + 1, sizeof(wchar_t)));
  for (std::size_t n = 0; n < text.size(); ++n) out[n] = static_cast<wchar_t>(text[n]);
  return out;
}

// A handle is its number, from 1 on.
int number_of(hid_device* device) {
  return static_cast<int>(reinterpret_cast<std::intptr_t>(device)) - 1;
}

}  // namespace

// The library hides everything else.
#pragma GCC visibility push(default)
extern "C" {

int HID_API_EXPORT hid_init() { return 0; }
int HID_API_EXPORT hid_exit() { return 0; }

hid_device_info* HID_API_EXPORT hid_enumerate(unsigned short vendor, unsigned short product) {
  hid_device_info* first = nullptr;
  hid_device_info** next = &first;
  for (const auto& listing : world().list()) {
    if ((vendor != 0 && vendor != listing.vendor) || (product != 0 && product != listing.product))
      continue;
    auto* info = static_cast<hid_device_info*>(std::calloc(1, sizeof(hid_device_info)));
    info->path = strdup(listing.path.c_str());
    info->vendor_id = listing.vendor;
    info->product_id = listing.product;
    info->usage_page = listing.usage_page;
    info->usage = listing.usage;
    info->product_string = wide(listing.name);
    info->serial_number = wide(listing.serial);
    info->bus_type = listing.bluetooth ? HID_API_BUS_BLUETOOTH : HID_API_BUS_USB;
    *next = info;
    next = &info->next;
  }
  return first;
}

void HID_API_EXPORT hid_free_enumeration(hid_device_info* info) {
  while (info != nullptr) {
    hid_device_info* const next = info->next;
    std::free(info->path);
    std::free(info->product_string);
    std::free(info->serial_number);
    std::free(info);
    info = next;
  }
}

hid_device* HID_API_EXPORT hid_open_path(const char* path) {
  const int handle = world().open(path);
  return handle < 0 ? nullptr : reinterpret_cast<hid_device*>(std::intptr_t{handle} + 1);
}

int HID_API_EXPORT hid_read_timeout(hid_device* device, unsigned char* data, size_t length,
                                    int milliseconds) {
  return world().read(number_of(device), data, length, milliseconds);
}

int HID_API_EXPORT hid_write(hid_device* device, const unsigned char* data, size_t length) {
  return world().write(number_of(device), data, length) ? static_cast<int>(length) : -1;
}

int HID_API_EXPORT hid_get_feature_report(hid_device* device, unsigned char* data, size_t length) {
  return world().feature(number_of(device), data, length);
}

void HID_API_EXPORT hid_close(hid_device* device) { world().close(number_of(device)); }

}  // extern "C"
#pragma GCC visibility pop

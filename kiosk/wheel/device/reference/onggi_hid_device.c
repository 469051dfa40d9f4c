#include "onggi_hid_device.h"

enum { MODE_OFF = 0, MODE_ARM = 1, MODE_FORCE = 2 };
enum { GOOD = 0, BAD_CHECK = 1, OLD = 2, RAN_OUT = 3, NOT_ARMED = 4, NOT_HELD = 5, SUSPENDED = 6 };

/* CRC-32 of IEEE 802.3, bit by bit: 20 bytes take some 2 us on a 100 MHz processor. */
static uint32_t check_of(const uint8_t* bytes, size_t size) {
  uint32_t c = 0xFFFFFFFFu;
  for (size_t i = 0; i < size; ++i) {
    c ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) c = (c & 1u) != 0 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
  }
  return ~c;
}

static uint16_t u16_at(const uint8_t* bytes) { return (uint16_t)(bytes[0] | bytes[1] << 8); }
static int16_t i16_at(const uint8_t* bytes) { return (int16_t)u16_at(bytes); }
static uint32_t u32_at(const uint8_t* bytes) {
  return (uint32_t)u16_at(bytes) | (uint32_t)u16_at(bytes + 2) << 16;
}
static void put_u16(uint8_t* bytes, uint16_t value) {
  bytes[0] = (uint8_t)(value & 0xFFu);
  bytes[1] = (uint8_t)(value >> 8);
}
static void put_u32(uint8_t* bytes, uint32_t value) {
  put_u16(bytes, (uint16_t)(value & 0xFFFFu));
  put_u16(bytes + 2, (uint16_t)(value >> 16));
}

/* The whole part of the square root. */
static uint32_t root(uint64_t value) {
  uint64_t result = 0;
  for (uint64_t bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
    if (value >= result + bit) {
      value -= result + bit;
      result = (result >> 1) + bit;
    } else {
      result >>= 1;
    }
  }
  return (uint32_t)result;
}

/* `v` shortened to `most`, never longer by a rounding: towards zero. */
static void shorten(int32_t v[3], int32_t most) {
  uint64_t square = 0;
  for (int n = 0; n < 3; ++n) square += (uint64_t)((int64_t)v[n] * v[n]);
  if (square <= (uint64_t)((int64_t)most * most)) return;
  const int64_t length = (int64_t)root(square) + 1;
  for (int n = 0; n < 3; ++n) v[n] = (int32_t)((int64_t)v[n] * most / length);
}

static void no_force(onggi_hid_device* device) {
  for (int n = 0; n < 3; ++n) device->wanted_mn[n] = 0;
  device->damping = 0;
  device->left_us = device->letting_us = 0;
  device->armed = 0;
}

void onggi_hid_start(onggi_hid_device* device, const onggi_hid_build* build) {
  const onggi_hid_device fresh = {0};
  *device = fresh;
  device->build = *build;
  if (device->build.let_go_ms == 0) device->build.let_go_ms = 1;
}

static int refuse(onggi_hid_device* device, uint16_t why) {
  device->status = why;
  return 0;
}

static int arm(onggi_hid_device* device, const uint8_t* bytes) {
  for (int n = 0; n < 3; ++n)
    if (i16_at(bytes + 4 + 2 * n) != 0) return refuse(device, NOT_ARMED);
  if (device->build.has_hand_sensor && !device->held) return refuse(device, NOT_HELD);
  device->armed = 1;
  return 1;
}

static int push(onggi_hid_device* device, const uint8_t* bytes) {
  if (!device->armed) return refuse(device, NOT_ARMED);
  int32_t wanted[3];
  for (int n = 0; n < 3; ++n) wanted[n] = i16_at(bytes + 4 + 2 * n);
  const uint16_t cap = u16_at(bytes + 14);
  const uint16_t most = device->build.max_force_mn;
  device->most_mn = cap < most ? cap : most;
  shorten(wanted, device->most_mn);
  for (int n = 0; n < 3; ++n) device->wanted_mn[n] = wanted[n];
  device->damping = u16_at(bytes + 10);
  return 1;
}

int onggi_hid_take(onggi_hid_device* device, const uint8_t* bytes, size_t size) {
  if (size != ONGGI_HID_OUTPUT_SIZE || bytes[0] != 2 || bytes[1] > MODE_FORCE ||
      u32_at(bytes + 16) != check_of(bytes, 16))
    return refuse(device, BAD_CHECK);
  const uint16_t sequence = u16_at(bytes + 2);
  const uint8_t mode = bytes[1];
  /* Off is taken whatever its sequence: a kiosk that begins anew begins with it. */
  if (mode != MODE_OFF && device->has_sequence &&
      (int16_t)(uint16_t)(sequence - device->out_sequence) <= 0)
    return refuse(device, OLD);
  device->has_sequence = 1;
  device->out_sequence = sequence;
  if (mode == MODE_OFF) {
    no_force(device);
    device->status = device->suspended ? SUSPENDED : GOOD;
    return 1;
  }
  if (device->suspended) return refuse(device, SUSPENDED);
  if (!(mode == MODE_ARM ? arm(device, bytes) : push(device, bytes))) return 0;
  const uint16_t ttl_ms = u16_at(bytes + 12);
  device->left_us = (uint32_t)(ttl_ms == 0 ? 1 : ttl_ms) * 1000u;
  device->letting_us = 0;
  device->status = GOOD;
  return 1;
}

static void let_time_pass(onggi_hid_device* device, uint32_t us) {
  if (device->left_us > us) {
    device->left_us -= us;
    return;
  }
  if (device->armed) {
    /* Nobody tells it what to do: it lets go, and wants to be armed anew. */
    device->armed = 0;
    device->status = RAN_OUT;
    device->letting_us = (uint32_t)device->build.let_go_ms * 1000u;
    device->left_us = 0;
    return;
  }
  device->left_us = 0;
  device->letting_us = device->letting_us > us ? device->letting_us - us : 0;
  if (device->letting_us == 0) no_force(device);
}

void onggi_hid_tick(onggi_hid_device* device, uint32_t us, const int32_t position[3], int held,
                    int powered, uint16_t buttons) {
  device->time_us += us;
  device->held = (uint8_t)(held != 0);
  device->powered = (uint8_t)(powered != 0);
  device->buttons = buttons;
  for (int n = 0; n < 3; ++n) {
    /* The difference of two places is rough at one tick: a quarter of it each time. */
    const int64_t moved = (int64_t)position[n] - device->position_01um[n];
    const int64_t speed = us == 0 || !device->has_place ? 0 : moved * 100000 / us;
    const int64_t bounded = speed > 5000000 ? 5000000 : speed < -5000000 ? -5000000 : speed;
    device->speed_um_s[n] += (int32_t)((bounded - device->speed_um_s[n]) / 4);
    device->position_01um[n] = position[n];
  }
  device->has_place = 1;
  let_time_pass(device, us);
}

void onggi_hid_force(const onggi_hid_device* device, int32_t force_mn[3]) {
  const int pushes = device->powered && !device->suspended && (device->armed || device->letting_us);
  const uint32_t whole = (uint32_t)device->build.let_go_ms * 1000u;
  for (int n = 0; n < 3; ++n) {
    int64_t f = pushes ? device->wanted_mn[n] : 0;
    if (pushes && device->armed)
      f -= (int64_t)device->damping * device->speed_um_s[n] / 1000000;
    else if (pushes)
      f = f * device->letting_us / whole;
    force_mn[n] = (int32_t)(f > 65535 ? 65535 : f < -65535 ? -65535 : f);
  }
  shorten(force_mn, device->most_mn);
}

void onggi_hid_input(onggi_hid_device* device, uint8_t bytes[ONGGI_HID_INPUT_SIZE]) {
  bytes[0] = 1;
  bytes[1] = (uint8_t)(device->armed | device->build.has_hand_sensor << 1 | device->held << 2 |
                       device->powered << 3);
  put_u16(bytes + 2, ++device->in_sequence);
  put_u32(bytes + 4, device->time_us);
  for (int n = 0; n < 3; ++n) put_u32(bytes + 8 + 4 * n, (uint32_t)device->position_01um[n]);
  put_u16(bytes + 20, device->buttons);
  put_u16(bytes + 22, device->out_sequence);
  put_u16(bytes + 24, device->status);
  put_u16(bytes + 26, 0);
  put_u32(bytes + 28, check_of(bytes, 28));
}

void onggi_hid_feature(const onggi_hid_device* device, uint8_t bytes[ONGGI_HID_FEATURE_SIZE]) {
  bytes[0] = 3;
  bytes[1] = 1;
  put_u16(bytes + 2, device->build.max_force_mn);
  for (int n = 0; n < 3; ++n) {
    put_u16(bytes + 4 + 2 * n, (uint16_t)device->build.least_01mm[n]);
    put_u16(bytes + 10 + 2 * n, (uint16_t)device->build.most_01mm[n]);
  }
  put_u16(bytes + 16, device->build.resolution_01um);
  put_u16(bytes + 18, device->build.firmware);
  put_u32(bytes + 20, 0);
  put_u32(bytes + 24, check_of(bytes, 24));
}

void onggi_hid_suspend(onggi_hid_device* device) {
  no_force(device);
  device->suspended = 1;
  device->status = SUSPENDED;
}

void onggi_hid_resume(onggi_hid_device* device) { device->suspended = 0; }

const uint8_t onggi_hid_report_descriptor[] = {
    0x06, 0x00, 0xFF,       /* Usage Page (vendor, FF00) */
    0x09, 0x01,             /* Usage (1) */
    0xA1, 0x01,             /* Collection (application) */
    0x15, 0x00,             /*   Logical Minimum (0) */
    0x26, 0xFF, 0x00,       /*   Logical Maximum (255) */
    0x75, 0x08,             /*   Report Size (8) */
    0x85, 0x01,             /*   Report ID (1) */
    0x09, 0x01, 0x95, 0x1F, /*   31 bytes */
    0x81, 0x02,             /*   Input */
    0x85, 0x02,             /*   Report ID (2) */
    0x09, 0x02, 0x95, 0x13, /*   19 bytes */
    0x91, 0x02,             /*   Output */
    0x85, 0x03,             /*   Report ID (3) */
    0x09, 0x03, 0x95, 0x1B, /*   27 bytes */
    0xB1, 0x02,             /*   Feature */
    0xC0};                  /* End Collection */
const size_t onggi_hid_report_descriptor_size = sizeof onggi_hid_report_descriptor;

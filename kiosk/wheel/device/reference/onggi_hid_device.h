/* The device's side of onggi-hid, version 1, in portable C99: kiosk/docs/onggi-hid.md says what it
 * does and why, kiosk/docs/build_a_hand.md how to build a device around it. Whole numbers only, no
 * library but the language's own headers, no allocation; one thread or interrupt level at a time.
 * The firmware gives it encoder positions and report bytes; it gives report bytes and forces. */
#ifndef ONGGI_HID_DEVICE_H
#define ONGGI_HID_DEVICE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define ONGGI_HID_INPUT_SIZE 32
#define ONGGI_HID_OUTPUT_SIZE 20
#define ONGGI_HID_FEATURE_SIZE 28

/* What was built. */
typedef struct {
  uint16_t max_force_mn; /* The most that the motors may push, mN. */
  uint16_t let_go_ms;    /* A force whose ttl ran out goes to zero within this long; 1 or more. */
  int16_t least_01mm[3]; /* Workspace, tenths of a millimetre from the frame's middle: */
  int16_t most_01mm[3];  /* x to the visitor's right, y up, z towards the visitor. */
  uint16_t resolution_01um; /* Of a position, tenths of a micrometre. */
  uint16_t firmware;        /* Major and minor, a byte each. */
  uint8_t has_hand_sensor;  /* 1: it feels whether a hand is at the handle. */
} onggi_hid_build;

/* All that it remembers. Private: read it through the functions. */
typedef struct {
  onggi_hid_build build;
  uint8_t armed, held, powered, has_sequence, suspended, has_place;
  uint16_t out_sequence, in_sequence, status, buttons;
  uint32_t time_us;
  uint32_t left_us;    /* Until the ttl runs out. */
  uint32_t letting_us; /* Of let_go_ms, once it has. */
  int32_t position_01um[3], speed_um_s[3];
  int32_t wanted_mn[3]; /* As told, within the cap. */
  uint16_t damping;     /* mN s/m */
  uint16_t most_mn;     /* The cap as told, within max_force_mn. */
} onggi_hid_device;

/* At switching on. Not armed, no force. */
void onggi_hid_start(onggi_hid_device* device, const onggi_hid_build* build);

/* An output report came: `size` bytes with the id first. Returns 1 where it was taken. */
int onggi_hid_take(onggi_hid_device* device, const uint8_t* bytes, size_t size);

/* `us` microseconds (1..100000) have passed; the handle is at `position` (tenths of a micrometre),
 * `held` by a hand or not, its motors `powered` or not. Call it at 1 kHz or quicker. */
void onggi_hid_tick(onggi_hid_device* device, uint32_t us, const int32_t position[3], int held,
                    int powered, uint16_t buttons);

/* What to push with now, mN: never beyond max_force_mn, and all zero unless armed and powered, or
 * letting go. Turn it into motor currents, and look at it again before each. */
void onggi_hid_force(const onggi_hid_device* device, int32_t force_mn[3]);

/* The next input report. */
void onggi_hid_input(onggi_hid_device* device, uint8_t bytes[ONGGI_HID_INPUT_SIZE]);
/* The feature report, whenever it is asked for. */
void onggi_hid_feature(const onggi_hid_device* device, uint8_t bytes[ONGGI_HID_FEATURE_SIZE]);

/* The bus was suspended, or the cable went: no force from this moment on. */
void onggi_hid_suspend(onggi_hid_device* device);
void onggi_hid_resume(onggi_hid_device* device);

/* What the USB stack is to say it is. */
extern const uint8_t onggi_hid_report_descriptor[];
extern const size_t onggi_hid_report_descriptor_size;

#ifdef __cplusplus
}
#endif
#endif

// Colour and noise, in front of every program.

const float kPi = 3.14159265;

vec3 to_display(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-5)), vec3(1.0 / 2.4)) - 0.055,
             step(vec3(0.0031308), c));
}

// The one tone mapper. Below the knee colours pass unchanged; above it the brightest channel bends
// towards 1 with matching slope and the colour pales as much as it was bent, so hues do not shift.
vec3 tone(vec3 c) {
  const float knee = 0.76;
  float peak = max(c.r, max(c.g, c.b));
  if (peak <= knee) return c;
  float over = (peak - knee) / (1.0 - knee);
  float bent = knee + (1.0 - knee) * (1.0 - exp(-over));
  float pale = 1.0 - 1.0 / (1.0 + 0.12 * (peak - bent));
  return mix(c * (bent / peak), vec3(bent), pale);
}

// Even noise in -1..1 with a triangular spread, different at every pixel: one step of 8 bits of it
// hides the banding of slow gradients.
float dither_noise(vec2 pixel) {
  float a = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  float b = fract(52.9829189 * fract(dot(pixel + 47.0, vec2(0.00583715, 0.06711056))));
  return a + b - 1.0;
}

vec3 dithered(vec3 display, vec2 pixel) { return display + dither_noise(pixel) / 255.0; }

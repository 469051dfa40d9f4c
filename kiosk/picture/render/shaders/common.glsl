// Colour, noise and tables, in front of every program.

const float kPi = 3.14159265;

// Reads a table between its texels, at share x of its width: a row of floats at share v of its
// height; and the clay's radii, which wrap round in x. OpenGL ES filters neither 32-bit floats nor
// integers, so there the shader interpolates.
#ifdef GL_ES
#define RADII usampler2D
vec4 between(sampler2D table, float x, float v) {
  ivec2 size = textureSize(table, 0);
  float at = clamp(x * float(size.x) - 0.5, 0.0, float(size.x - 1));
  int low = int(at), row = int(v * float(size.y));
  return mix(texelFetch(table, ivec2(low, row), 0),
             texelFetch(table, ivec2(min(low + 1, size.x - 1), row), 0), at - float(low));
}
float radius_between(usampler2D table, vec2 p) {
  ivec2 size = textureSize(table, 0);
  vec2 at = vec2(fract(p.x), p.y) * vec2(size) - 0.5;
  at.y = clamp(at.y, 0.0, float(size.y - 1));
  vec2 low = floor(at), part = at - low;
  int left = (int(low.x) + size.x) % size.x, right = (int(low.x) + 1) % size.x;
  int down = int(low.y), up = min(down + 1, size.y - 1);
  vec2 a = vec2(texelFetch(table, ivec2(left, down), 0).r, texelFetch(table, ivec2(right, down), 0).r);
  vec2 b = vec2(texelFetch(table, ivec2(left, up), 0).r, texelFetch(table, ivec2(right, up), 0).r);
  vec2 across = mix(a, b, part.y);
  return mix(across.x, across.y, part.x) / 65535.0;
}
#else
#define RADII sampler2D
#define between(table, x, v) textureLod(table, vec2(x, v), 0.0)
#define radius_between(table, p) textureLod(table, p, 0.0).r
#endif

vec3 to_display(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-5)), vec3(1.0 / 2.4)) - 0.055,
             step(vec3(0.0031308), c));
}

// The only tone mapping. Below the knee colours stay unchanged. Above it the brightest channel
// bends towards 1 with matching slope, and the colour pales with the bend, so that hues do not
// shift.
vec3 tone(vec3 c) {
  const float knee = 0.76;
  float peak = max(c.r, max(c.g, c.b));
  if (peak <= knee) return c;
  float over = (peak - knee) / (1.0 - knee);
  float bent = knee + (1.0 - knee) * (1.0 - exp(-over));
  float pale = 1.0 - 1.0 / (1.0 + 0.12 * (peak - bent));
  return mix(c * (bent / peak), vec3(bent), pale);
}

// Noise in -1..1 with a triangular distribution, different at every pixel. One 8-bit step of it
// hides the banding of slow gradients.
float dither_noise(vec2 pixel) {
  float a = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  float b = fract(52.9829189 * fract(dot(pixel + 47.0, vec2(0.00583715, 0.06711056))));
  return a + b - 1.0;
}

vec3 dithered(vec3 display, vec2 pixel) { return display + dither_noise(pixel) / 255.0; }

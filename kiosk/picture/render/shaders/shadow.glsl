// The vessel's shadow from above: how much of window and sky reaches the plane that it stands on
// (r, g), and the table under the wheel head (b, a). The texture is small, so soft edges cost
// nothing later.

uniform sampler2D levels;
uniform vec3 window_dir;
uniform float reach, height, table_y, wheel_radius;

#ifdef VERTEX
layout(location = 0) in vec2 place;
out vec2 ground;
void main() {
  ground = (place * 2.0 - 1.0) * reach;
  gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
in vec2 ground;
out vec4 color;

// What a disc of radius r at height h over the point leaves of the window (x) and the sky (y).
vec2 left_by(vec2 p, float r, float h) {
  float along = h / max(window_dir.y, 0.05);
  vec2 q = p + window_dir.xz * along;
  float soft = 0.0025 + 0.24 * along;
  // Across the light the window is narrow, so the shadow's edge is crisper than along it.
  float window = smoothstep(r - 0.55 * soft, r + 0.45 * soft + 1e-4, length(q));
  float wide = 2.0 * min(r / (0.27 * along + 1e-4), 1.0);
  window = mix(1.0, window, min(wide, 1.0));
  float rho = length(p), d = rho - r, hidden;
  if (d > 0.0) {
    hidden = asin(min(r / rho, 1.0)) / kPi * h * h / (h * h + d * d + 1e-8);
  } else {
    hidden = 0.5 - 0.5 * d / sqrt(d * d + h * h + 1e-8);
  }
  return vec2(window, 1.0 - hidden);
}

void main() {
  vec2 top = vec2(1.0), table = left_by(ground, wheel_radius, -table_y);
  for (int i = 0; i < 32; ++i) {
    float t = (float(i) + 0.5) / 32.0;
    float r = between(levels, t, 0.25).x, h = t * height;
    top = min(top, left_by(ground, r, h));
    table = min(table, left_by(ground, r, h - table_y));
  }
  color = vec4(top, table);
}
#endif

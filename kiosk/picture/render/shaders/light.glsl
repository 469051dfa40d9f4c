// The studio's light on a vessel of revolution: one soft window, and everything else as nine
// spherical-harmonic terms. The vessel's own profile tells what it shades (levels.cpp).

uniform vec3 sh[9];          // irradiance / pi of the studio without its window, which is at the left
uniform vec2 room_turn;      // cosine and sine of the angle by which the room is turned from that
uniform vec3 window_dir;     // unit, towards the window's middle
uniform vec3 window_across;  // unit, level
uniform vec3 window_up;      // unit
uniform vec3 window_light;   // irradiance / pi on a surface that faces it
uniform sampler2D sky;       // octahedral, each level rougher
uniform sampler2D levels;    // row 0: outer wall, row 1: inner wall, over the vessel's height
uniform vec3 eye;

const vec2 kWindowHalf = vec2(0.27, 0.62);  // tangents of its half width and half height

vec3 in_room(vec3 d) {
  return vec3(d.x * room_turn.x - d.z * room_turn.y, d.y, d.z * room_turn.x + d.x * room_turn.y);
}

vec3 ambient(vec3 d) {
  vec3 n = in_room(d);
  return sh[0] + sh[1] * n.y + sh[2] * n.z + sh[3] * n.x + sh[4] * (n.x * n.y) +
         sh[5] * (n.y * n.z) + sh[6] * (3.0 * n.z * n.z - 1.0) + sh[7] * (n.x * n.z) +
         sh[8] * (n.x * n.x - n.y * n.y);
}

// Cosine for a light about 20 degrees wide, which reaches a little past the terminator.
float wrapped(float cosine) {
  const float reach = 0.22;
  float c = clamp((cosine + reach) / (1.0 + reach), 0.0, 1.0);
  return c * (0.35 * c + 0.65);
}

vec3 sky_at(vec3 direction, float level) {
  vec3 d = in_room(direction);
  vec3 a = d / (abs(d.x) + abs(d.y) + abs(d.z));
  vec2 s = vec2(a.x >= 0.0 ? 1.0 : -1.0, a.z >= 0.0 ? 1.0 : -1.0);
  vec2 p = a.y >= 0.0 ? a.xz : (1.0 - abs(a.zx)) * s;
  return textureLod(sky, 0.5 + 0.5 * p, level).rgb;
}

// Reflection of the window in direction `d`, softened by roughness, with its glazing bars where
// they can be resolved.
float window_seen(vec3 d, float roughness) {
  float facing = dot(d, window_dir);
  if (facing <= 0.05) return 0.0;
  vec2 p = vec2(dot(d, window_across), dot(d, window_up)) / facing;
  float soft = 0.015 + 1.1 * roughness * roughness;
  vec2 inside = 1.0 - smoothstep(kWindowHalf - soft, kWindowHalf + soft, abs(p));
  vec2 bar = smoothstep(vec2(0.0), vec2(soft), abs(vec2(p.x, abs(p.y) - 0.2)) - 0.018);
  float bars = mix(bar.x * bar.y, 1.0, smoothstep(0.05, 0.4, soft));
  vec2 spread = kWindowHalf / (kWindowHalf + 0.7 * soft);
  return inside.x * inside.y * bars * spread.x * spread.y;
}

vec3 specular(vec3 n, vec3 v, float roughness, float f0, float seen_sky, float seen_window) {
  float cosine = clamp(dot(n, v), 0.0, 1.0);
  float grazing = 1.0 - cosine;
  float g2 = grazing * grazing;
  float fresnel = f0 + (max(1.0 - roughness, f0) - f0) * g2 * g2 * grazing;
  vec3 r = reflect(-v, n);
  vec3 studio = sky_at(r, roughness * 4.0) * seen_sky;
  return fresnel * (studio + window_light * (9.0 * seen_window * window_seen(r, roughness)));
}

struct Seen {
  float sky;     // share of the studio that reaches the point
  float window;  // share of the window
  vec3 bounce;   // light from clay to clay, as a factor on the sky's light
};

// A point of the outer wall at share `t` of the height. Shoulders shade what lies below them.
Seen seen_outside(vec3 p, vec3 n, float t) {
  vec4 level = between(levels, t, 0.25);
  vec2 out_dir = normalize(p.xz + vec2(1e-6, 0.0));
  // Angle of the light from the vertical, in the meridian plane; the wall above ends at level.y.
  float lean = atan(dot(window_dir.xz, out_dir), window_dir.y);
  Seen s;
  s.window = smoothstep(-0.62, 0.02, lean - level.y);
  s.sky = level.z;
  s.bounce = vec3(1.0);
  return s;
}

// A point of the inner wall or floor, at share `t` of the height. It sees the sky through the
// narrowest ring above it, a disc of radius a at height d. Share seen: facing up a^2/(a^2+d^2);
// facing the axis, the exact view factor of a tube's wall to its mouth. The clay scatters what
// stays inside.
Seen seen_inside(vec3 p, vec3 n, float t, vec3 albedo, float opened) {
  vec4 level = between(levels, t, 0.75);
  float a = max(level.y, 1e-4), d = max(level.z - p.y, 0.0);
  float facing_up = a * a / (a * a + d * d);
  float z = d / (a + max(level.x, 1e-4));
  float facing_axis = 2.0 * ((z * z + 0.5) / sqrt(z * z + 1.0) - z);
  float share = mix(facing_axis, facing_up, clamp(n.y, 0.0, 1.0));
  share = mix(share, 1.0, 0.6 * opened);
  float along = d / max(window_dir.y, 0.05);
  vec2 q = p.xz + window_dir.xz * along;
  float soft = 0.0015 + 0.2 * along;
  Seen s;
  s.window = 1.0 - smoothstep(a - soft, a + soft, length(q));
  s.sky = share;
  s.bounce = 1.0 / (1.0 - albedo * (1.0 - share) * 0.9);
  return s;
}

vec3 diffuse_light(vec3 n, Seen s) {
  return ambient(n) * s.sky * s.bounce + window_light * (wrapped(dot(n, window_dir)) * s.window);
}

// Meshes under the studio's light. PART: 0 vessels of the shelf, 1 the potter's fingertip.

uniform mat4 clip_from_studio;
uniform vec3 base_color, tip, lean;
uniform float height, size;

#ifdef VERTEX
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal_in;
out vec3 position, normal_v;
out float finger;  // 0 at the tip .. 1 where it fades

void main() {
  position = at;
  normal_v = normal_in;
  finger = 0.0;
#if PART == 1
  // A unit sphere, its far half drawn out along the finger and a little thicker there.
  finger = max(dot(at, lean), 0.0);
  position = tip + size * (at * (1.0 + 0.22 * finger) + lean * finger * 3.4);
#endif
  gl_Position = clip_from_studio * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
in vec3 position, normal_v;
in float finger;
out vec4 color;

void main() {
  vec3 n = normalize(normal_v), v = normalize(eye - position);
  Seen s;
#if PART == 1
  s.sky = 0.85;
  s.window = 0.9;
  s.bounce = vec3(1.0);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 light = base_color * (diffuse_light(n, s) + vec3(0.10, 0.05, 0.03) * (1.0 - facing));
  light += specular(n, v, 0.3, 0.04, 0.8, 0.8);
  float cover = smoothstep(0.0, 0.45, facing) * (1.0 - smoothstep(0.1, 0.95, finger)) * 0.93;
  color = vec4(dithered(to_display(tone(light)), gl_FragCoord.xy), 1.0) * cover;
#else
  // Scans have holes and turned-in faces: light both sides.
  if (dot(n, v) < 0.0 && !gl_FrontFacing) n = -n;
  float rho = length(position.xz), t = clamp(position.y / height, 0.0, 1.0);
  vec4 wall = texture(levels, vec2(t, 0.75));
  bool inside = dot(n.xz, position.xz) < -0.15 * rho * (1.0 - n.y) &&
                rho < 0.5 * (wall.x + texture(levels, vec2(t, 0.25)).x);
  bool floor_ = n.y > 0.6 && rho < wall.x * 0.98 && position.y < 0.9 * height;
  if (inside || floor_) {
    s = seen_inside(position, n, t, base_color, 0.0);
  } else {
    s = seen_outside(position, n, t);
    s.sky *= 1.0 - 0.55 * exp(-max(t, 0.0) / 0.06) * (0.6 - 0.4 * n.y);
  }
  vec3 light = base_color * diffuse_light(n, s);
  light += specular(n, v, 0.42, 0.035, s.sky * s.sky, s.window * 0.8);
  color = vec4(dithered(to_display(tone(light)), gl_FragCoord.xy), 1.0);
#endif
}
#endif

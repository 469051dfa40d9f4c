// Vessels of the shelf under the studio's light.

uniform mat4 clip_from_studio;
uniform sampler2D own_picture;  // sRGB, decoded when read
uniform float height;
uniform float turned;  // about its axis, rad

#ifdef VERTEX
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in vec3 color_in;  // linear
layout(location = 3) in vec2 place_in;
out vec3 position, normal_v, color_v;
out vec2 place_v;

void main() {
  float c = cos(turned), s = sin(turned);
  mat3 turn = mat3(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c);
  position = turn * at;
  normal_v = turn * normal_in;
  color_v = color_in;
  place_v = place_in;
  gl_Position = clip_from_studio * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
in vec3 position, normal_v, color_v;
in vec2 place_v;
out vec4 color;

void main() {
  vec3 n = normalize(normal_v), v = normalize(eye - position);
  vec3 base_color = color_v * texture(own_picture, place_v).rgb;
  Seen s;
  // Scans have holes and inverted faces, so light both sides.
  if (dot(n, v) < 0.0 && !gl_FrontFacing) n = -n;
  float rho = length(position.xz), t = clamp(position.y / height, 0.0, 1.0);
  vec4 wall = between(levels, t, 0.75);
  bool inside = dot(n.xz, position.xz) < -0.15 * rho * (1.0 - n.y) &&
                rho < 0.5 * (wall.x + between(levels, t, 0.25).x);
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
}
#endif

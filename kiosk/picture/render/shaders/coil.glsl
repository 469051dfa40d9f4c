// A coil of clay on the rim (coil_mesh.cpp), without water of its own: as wet as the rim below it.

uniform mat4 clip_from_studio;
uniform sampler2D grain;
uniform float rim, coil, clay_angle, wetness;

#ifdef VERTEX
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal_in;
out vec3 position, normal_v;

void main() {
  position = at;
  normal_v = normal_in;
  gl_Position = clip_from_studio * vec4(at, 1.0);
}
#endif

#ifdef FRAGMENT
in vec3 position, normal_v;
out vec4 color;

void main() {
  vec3 n = normalize(normal_v), v = normalize(eye - position);
  // The grain turns with the clay.
  float c = cos(clay_angle), s_ = sin(clay_angle);
  vec3 own = vec3(c * position.x + s_ * position.z, position.y, c * position.z - s_ * position.x);
  float fleck = textureLod(grain, 22.0 * vec2(own.x + own.z, own.y + 0.4 * (own.x - own.z)), 0.0).r - 0.5;
  Surface skin = of_clay(wetness, 0.0, fleck);
  Seen s = seen_outside(position, n, 1.0);
  // Little light gets between the coil and the rim.
  float shut = exp(-max(position.y - rim, 0.0) / (0.16 * coil)) * (0.75 - 0.25 * n.y);
  s.sky *= 1.0 - 0.75 * shut;
  s.window *= 1.0 - 0.6 * shut;
  vec3 light = skin.albedo * diffuse_light(n, s);
  light += specular(n, v, skin.roughness, skin.coat, s.sky, s.window);
  color = vec4(dithered(to_display(tone(light)), gl_FragCoord.xy), 1.0);
}
#endif

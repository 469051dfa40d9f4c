// The wheel head: dark turned wood, wet with slip where the potter works, with a dab of white slip
// that shows its turning.

uniform mat4 clip_from_studio;
uniform sampler2D shadow, grain;
uniform float radius, table_y, reach, wheel_angle, wetness, pixel, opened;

#ifdef VERTEX
layout(location = 0) in vec3 place;  // round, along, 1 for the band
out vec3 position;
flat out float side;
void main() {
  side = place.z;
  float angle = place.x * 2.0 * kPi;
  vec2 d = vec2(cos(angle), sin(angle));
  position = place.z < 0.5 ? vec3(d.x * radius * place.y, 0.0, d.y * radius * place.y)
                           : vec3(d.x * radius, table_y * place.y, d.y * radius);
  gl_Position = clip_from_studio * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
in vec3 position;
flat in float side;
out vec4 color;

void main() {
  float rho = length(position.xz);
  float c = cos(wheel_angle), s = sin(wheel_angle);
  vec2 own = vec2(c * position.x + s * position.z, -s * position.x + c * position.z);
  bool top = side < 0.5;
  vec3 n = top ? vec3(0.0, 1.0, 0.0) : vec3(position.x, 0.0, position.z) / radius;
  // The turned edge catches the light.
  float edge = smoothstep(radius - 0.003, radius, rho);
  if (top) n = normalize(n + vec3(position.x, 0.0, position.z) / rho * edge * 0.8);

  vec2 wood = own * vec2(2.2, 26.0);
  float fibre = textureLod(grain, wood * 0.6, 0.0).r - 0.5;
  float mottle = textureLod(grain, own * 2.3, 0.0).r - 0.5;
  vec3 albedo = vec3(0.105, 0.068, 0.046) * (1.0 + 0.30 * fibre + 0.25 * mottle);
  if (top) {
    // Fine centring rings, every 15 mm.
    float ring = abs(fract(rho / 0.015 + 0.5) - 0.5) * 0.015;
    float cut = 1.0 - smoothstep(0.0004, 0.0004 + 1.4 * pixel, ring);
    albedo *= 1.0 - 0.42 * cut * step(0.02, rho);
    // A film of slip round the pot, thinner outwards.
    float film = (1.0 - smoothstep(0.35, 0.95, rho / radius + 0.35 * mottle)) * (0.25 + 0.35 * wetness);
    albedo = mix(albedo, vec3(0.21, 0.125, 0.08), film);
    vec2 dab = (own - vec2(radius * 0.885, 0.0)) / vec2(0.0085, 0.0050);
    albedo = mix(albedo, vec3(0.72, 0.68, 0.60), 0.92 * (1.0 - smoothstep(0.75, 1.05, length(dab) + 0.3 * mottle)));
  }
  vec4 lit = texture(shadow, position.xz / reach * 0.5 + 0.5);
  Seen seen;
  seen.window = top ? lit.r : 1.0;
  seen.sky = top ? lit.g * lit.g : 0.35 + 0.65 * smoothstep(1.0, 0.0, position.y / table_y);
  // The place under the pot is dark, but an opened pot lets light through to it.
  if (top) seen.sky = max(seen.sky, 0.5 * opened);
  seen.bounce = vec3(1.0);
  vec3 v = normalize(eye - position);
  float rough = mix(0.62, 0.34, wetness) + 0.15 * mottle;
  vec3 light = albedo * diffuse_light(n, seen);
  light += specular(n, v, rough, 0.035, seen.sky, seen.window * 0.7);
  color = vec4(dithered(to_display(tone(light)), gl_FragCoord.xy), 1.0);
}
#endif

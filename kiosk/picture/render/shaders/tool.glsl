// A held tool's part: a unit body put in its place, of finger, wood, steel or sponge.

uniform mat4 clip_from_studio;
uniform vec3 middle, axis_x, axis_y, axis_z, half_size;
uniform float stretch;  // of the far half, along axis_y
uniform vec3 base_color;
uniform float roughness, mirrors, fibre, pores;
uniform vec2 fade;     // metres along axis_y between which it fades out
uniform float softly;  // 1: its edges are soft
uniform sampler2D grain;

#ifdef VERTEX
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in float far_half;
out vec3 position, normal_v, own, own_normal;

void main() {
  own = half_size * at + vec3(0.0, stretch * far_half, 0.0);
  position = middle + axis_x * own.x + axis_y * own.y + axis_z * own.z;
  own_normal = normal_in;
  normal_v = axis_x * normal_in.x + axis_y * normal_in.y + axis_z * normal_in.z;
  gl_Position = clip_from_studio * vec4(position, 1.0);
}
#endif

#ifdef FRAGMENT
in vec3 position, normal_v, own, own_normal;
out vec4 color;

// Mean of three planes, weighted by how much the surface faces each, so that no side is stretched.
float noise(vec3 p) {
  vec3 w = own_normal * own_normal;
  return dot(w, vec3(textureLod(grain, p.yz + 0.37, 0.0).r, textureLod(grain, p.zx + 0.71, 0.0).r,
                     textureLod(grain, p.xy, 0.0).r)) / (w.x + w.y + w.z) - 0.5;
}

void main() {
  vec3 n = normalize(normal_v), v = normalize(eye - position);
  // Fibres run along the tool on all sides.
  float wood = textureLod(grain, vec2(26.0 * own.x + 11.0 * own.z, 1.7 * own.y), 0.0).r - 0.5;
  float hole = smoothstep(0.0, 0.22, noise(own * 23.0)) * pores;
  vec3 albedo = base_color * (1.0 + fibre * 0.8 * wood) * (1.0 - 0.45 * hole);
  n = normalize(n + pores * 0.5 * vec3(noise(own * 23.0 + 0.13), noise(own * 23.0 + 0.29),
                                       noise(own * 23.0 + 0.53)));
  Seen s;
  s.sky = 0.85 * (1.0 - 0.4 * hole);
  s.window = 0.9;
  s.bounce = vec3(1.0);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 light = albedo * (diffuse_light(n, s) + softly * vec3(0.10, 0.05, 0.03) * (1.0 - facing));
  light += specular(n, v, roughness, mirrors, 0.8, 0.8);
  float cover = (1.0 - smoothstep(fade.x, fade.y, own.y)) *
                mix(1.0, 0.93 * smoothstep(0.0, 0.45, facing), softly);
  color = vec4(dithered(to_display(tone(light)), gl_FragCoord.xy), 1.0) * cover;
}
#endif

// The vessel's shadow on the plaster. MODE: 0 only the shadow, as a warm dark layer with alpha; 1
// the plaster with the shadow.

uniform mat4 clip_from_studio;
uniform sampler2D shadow;
uniform float reach, plane_y, foot;
uniform float of_table;  // 1: the table's half of the shadow texture
uniform float strength;
uniform vec2 low, high;  // the part that is drawn, metres
#if MODE == 1
uniform sampler2D plaster;  // one texel per pixel
uniform float opacity;
#endif
#if MODE == 0
uniform vec2 edge, size;  // pixels: the shadow fades out over `edge` towards the edges of a picture
                          // of `size`
#endif

#ifdef VERTEX
layout(location = 0) in vec2 place;
out vec2 ground;
void main() {
  ground = mix(low, high, place);
  gl_Position = clip_from_studio * vec4(ground.x, plane_y, ground.y, 1.0);
}
#endif

#ifdef FRAGMENT
in vec2 ground;
out vec4 color;
void main() {
  vec4 both = texture(shadow, ground / reach * 0.5 + 0.5);
  vec2 lit = of_table > 0.5 ? both.ba : both.rg;
  float fade = 1.0 - smoothstep(0.55, 0.98, length(ground) / reach);
  // The sky's part fades out a hand's breadth from the foot. A real shadow has no end, but the
  // picture has.
  float sky = mix(lit.y * lit.y, 1.0, smoothstep(0.0, 0.24, length(ground) - foot));
  float light = 0.46 * lit.x + 0.54 * sky;
  float dark = (1.0 - light) * fade * strength;
#if MODE == 1
  // A pot that fades is no window onto the dark that it stands on.
  if (opacity < 1.0) dark *= smoothstep(0.8 * foot, foot, length(ground));
#endif
#if MODE == 0
  vec2 within = smoothstep(0.0, 1.0, min(gl_FragCoord.xy, size - gl_FragCoord.xy) / edge);
  dark *= within.x * within.y;
#endif
  // Sky light from the north fills a shadow; clay and floor warm it.
  vec3 tint = mix(vec3(0.42, 0.335, 0.265), vec3(0.20, 0.15, 0.115), dark);
  float cover = clamp(dark * 0.92 + dither_noise(gl_FragCoord.xy) / 255.0 * step(0.004, dark), 0.0, 1.0);
#if MODE == 0
  color = vec4(tint, 1.0) * cover;
#else
  color = vec4(mix(texelFetch(plaster, ivec2(gl_FragCoord.xy), 0).rgb, tint, cover * opacity), 1.0);
#endif
}
#endif

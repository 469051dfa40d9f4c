// Ribbons along the outlines, at the frame's full size over a 3-D picture that may be smaller. A
// pixel there is what lies before the edge and what lies behind it, each by the share that it
// covers. What lies behind is read from the picture where the edge is out of its pixels' reach. What
// lies before changes fast near an edge, so it is drawn once more as strips (clay.glsl, wheel.glsl).

uniform vec2 size;   // of the frame, pixels
uniform float wide;  // of a ribbon to both sides, pixels
uniform sampler2D space, away, ground, strips;
uniform vec2 distance_of;  // the camera's, to turn depth into metres
uniform float opacity;

#ifdef VERTEX
layout(location = 0) in vec4 corner;  // pixels from the lower left, beyond the edge, metres
layout(location = 1) in vec3 strip_in;
layout(location = 2) in vec3 normal_in;  // away from what is before; 1: the strip has all of it
out vec2 place;  // pixels beyond the edge, metres before the eye
out vec3 strip;  // place of the edge in the strips, and its change in y a pixel; none: x < 0
out vec3 normal;

void main() {
  place = corner.zw;
  strip = strip_in;
  normal = normal_in;
  gl_Position = vec4(corner.xy / size * 2.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
in vec2 place;
in vec3 strip;
in vec3 normal;
out vec4 color;

void main() {
  vec2 n = normalize(normal.xy), at = gl_FragCoord.xy;
  float beyond = place.x;
  bool striped = strip.x >= 0.0;
  vec2 before_at = at - n * max(wide + beyond, 0.0), behind_at = at + n * max(wide - beyond, 0.0);
  vec4 before = texture(space, before_at / size);
  // Farther inside, the strip becomes the picture, which is as coarse as what lies beside it.
  if (striped)
    before = mix(texture(strips, vec2(strip.x, strip.y + strip.z * max(-beyond, 0.0))), before,
                 normal.z > 0.5 ? 0.0 : smoothstep(0.4, 1.0, -beyond / wide));
  vec4 behind = texture(space, behind_at / size);
  // A tool or a nearer wall hides the edge. What is before a round edge is itself nearer than it.
  float depth = texture(away, before_at / size).r;
  float metres = distance_of.y / (2.0 * depth - 1.0 + distance_of.x);
  if (metres < place.y - 0.06) discard;
  vec4 over = mix(behind, before, clamp(0.5 - beyond, 0.0, 1.0)) * opacity;
  color = vec4(over.rgb + texelFetch(ground, ivec2(at), 0).rgb * (1.0 - over.a), 1.0);
}
#endif

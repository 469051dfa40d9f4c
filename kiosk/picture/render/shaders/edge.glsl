// Ribbons along the outlines, at the frame's full size over a 3-D picture that is smaller. A pixel
// there is what lies before the edge and what lies behind it, each by the share that it covers. MODE:
// 0 an outline: the picture's depth tells of each texel on which side of the edge it lies; 1 a crease
// of one surface: its colours come from where no texel reaches over the crease.

uniform vec2 size;  // of the frame, pixels
uniform sampler2D space, away, ground, strips;
uniform float opacity;
#if MODE == 0
uniform vec4 head;  // the wheel head's depth by texel; by how much clay on it is nearer
uniform sampler2D bare;  // depths without the fingers, in the part `fingers`: left, low, right, high
uniform vec4 fingers;
uniform mat3 disc;  // the wheel head's ellipse by pixel: 0 on it, positive outside
#endif

#ifdef VERTEX
layout(location = 0) in vec3 corner;     // pixels from the lower left, and beyond the edge
layout(location = 1) in vec3 depths_in;  // as in ribbons.h
layout(location = 2) in vec3 strip_in;   // place in the strips, and its change in y a pixel; none: x < 0
out float beyond;
out vec3 depths, strip;

void main() {
  beyond = corner.z;
  depths = depths_in;
  strip = strip_in;
  gl_Position = vec4(corner.xy / size * 2.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
in float beyond;
in vec3 depths, strip;
out vec4 color;

#if MODE == 0
vec4 nearer, before, behind, wheel;  // sums of colours,
vec4 shares;                         // and of their weights
bool fingered;    // a finger, which fades, lies before a texel
vec2 far_shares;  // of texels before the edge and of the wheel head that are not on it

// `inside`: texels from the edge. On it light changes fast, and a texel shows it as a dash.
void take(ivec2 texel, float weight, float inside) {
  ivec2 at = clamp(texel, ivec2(0), textureSize(space, 0) - 1);
  float depth = texelFetch(away, at, 0).r;
  if (all(greaterThanEqual(vec2(at), fingers.xy)) && all(lessThan(vec2(at), fingers.zw))) {
    float without = texelFetch(bare, at, 0).r;
    fingered = fingered || depth < without;
    depth = without;
  }
  bool of_wheel = depths.z > 0.5;
  // Where clay meets the wheel head both are as deep.
  bool low = depths.z > -0.5 && depth > dot(head.xyz, vec3(at, 1.0)) + (inside > 0.0 && !of_wheel ? head.w : -head.w);
  bool hides = of_wheel ? !low : depth < depths.x;
  bool is_before = depth < depths.y && low == of_wheel;
  bool on_wheel = low && depth < 1.0;
  vec4 share = weight * (hides       ? vec4(1, 0, 0, 0)
                         : is_before ? vec4(0, 1, 0, 0)
                         : on_wheel  ? vec4(0, 0, 0, 1)
                                     : vec4(0, 0, 1, 0));
  vec4 c = texelFetch(space, at, 0);
  shares += share;
  nearer += share.x * c;
  share.yw *= smoothstep(0.0, 0.6, abs(inside));
  before += share.y * c;
  far_shares += share.yw;
  behind += share.z * c;
  wheel += share.w * c;
}
const float kFarther = 0.04;  // share of what lies farther inside
vec4 beside(vec2 at) { return texture(space, (at + 0.5) / vec2(textureSize(space, 0))); }
#endif

void main() {
  vec2 n = vec2(dFdx(beyond), dFdy(beyond));
  vec4 drawn = texture(strips, vec2(strip.x, strip.y + strip.z * max(-beyond, 0.0)));
  float cover = clamp(0.5 - beyond, 0.0, 1.0);
#if MODE == 0
  // Of the four texels about a point of the edge some lie on each side.
  vec2 at = (gl_FragCoord.xy - n * clamp(beyond, -1.0, 1.0)) / size * vec2(textureSize(space, 0)) - 0.5;
  vec2 low = floor(at), part = at - low;
  ivec2 texel = ivec2(low);
  shares = nearer = before = behind = wheel = vec4(0.0);
  far_shares = vec2(0.0);
  fingered = false;
  float texel_size = size.x / float(textureSize(space, 0).x);
  float inside = (clamp(beyond, -1.0, 1.0) - beyond) / texel_size + dot(n, part);
  take(texel, (1.0 - part.x) * (1.0 - part.y), inside);
  take(texel + ivec2(1, 0), part.x * (1.0 - part.y), inside - n.x);
  take(texel + ivec2(0, 1), (1.0 - part.x) * part.y, inside - n.y);
  take(texel + ivec2(1, 1), part.x * part.y, inside - n.x - n.y);
  // Behind clay the wheel head's far rim may pass between the texels.
  vec3 pixel = vec3(gl_FragCoord.xy, 1.0), out_ = disc * pixel;
  float on_disc = clamp(0.5 - 0.5 * dot(out_, pixel) / length(out_.xy), 0.0, 1.0);
  float both = shares.z + shares.w;
  bool rim = out_.y > 0.0 && shares.z > 0.0 && shares.w > 0.0;
  vec4 farther = beside(at + 1.5 * n);
  wheel = (wheel + kFarther * farther) / (far_shares.y + kFarther);
  behind = rim          ? mix(behind / shares.z, wheel, on_disc)
           : both > 0.0 ? mix(behind / max(shares.z, 1e-5), wheel, shares.w / both)
                        : farther;
  // The picture's coarse mesh may end a little off the edge.
  before = (before + kFarther * beside(at - 1.5 * n)) / (far_shares.x + kFarther);
  vec4 one = strip.x >= 0.0 && !fingered ? drawn : before;
  vec4 over = nearer + (1.0 - shares.x) * mix(behind, one, cover);
#else
  vec2 in_at = (gl_FragCoord.xy - n * max(depths.y + beyond, 0.0)) / size,
       out_at = (gl_FragCoord.xy + n * max(depths.x - beyond, 0.0)) / size;
  float nearest = min(texture(away, gl_FragCoord.xy / size).r,
                      min(texture(away, in_at).r, texture(away, out_at).r));
  vec4 inner = texture(space, in_at), outer = texture(space, out_at);
  if (nearest < depths.z || min(strip.x < 0.0 ? inner.a : 1.0, outer.a) < 0.99) discard;
  vec4 over = mix(outer, strip.x >= 0.0 ? drawn : inner, cover);
#endif
  over *= opacity;
  color = vec4(over.rgb + texelFetch(ground, ivec2(gl_FragCoord.xy), 0).rgb * (1.0 - over.a), 1.0);
}
#endif

// Flat items over the picture. Pixels from the top left. MODE: 0 box, 1 text mask, 2 picture, 3 line.

uniform vec2 size;      // of the frame, pixels
uniform vec4 rect;      // of the item: x, y, width, height
uniform vec4 part;      // pictures: the share of the texture, x, y, width, height
uniform vec4 fill, border_fill;
uniform float radius, border, opacity;
uniform sampler2D image;

#ifdef VERTEX
layout(location = 0) in vec2 place;    // 0..1 over the rect; or pixels for lines
layout(location = 1) in vec4 tint_in;  // lines: colour, premultiplied
layout(location = 2) in float across_in;
out vec2 pixel, uv;
out vec4 tint;
out float across;
void main() {
  float pad = MODE == 0 ? 1.0 : 0.0;
  pixel = MODE == 3 ? place : rect.xy - pad + place * (rect.zw + 2.0 * pad);
  uv = MODE == 2 ? part.xy + place * part.zw : place;
  tint = tint_in;
  across = across_in;
  gl_Position = vec4(pixel.x / size.x * 2.0 - 1.0, 1.0 - pixel.y / size.y * 2.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
in vec2 pixel, uv;
in vec4 tint;
in float across;
out vec4 color;

void main() {
#if MODE == 0
  vec2 half_size = 0.5 * rect.zw;
  float r = min(radius, min(half_size.x, half_size.y));
  vec2 d = abs(pixel - rect.xy - half_size) - half_size + r;
  float away = length(max(d, 0.0)) + min(max(d.x, d.y), 0.0) - r;
  float cover = clamp(0.5 - away, 0.0, 1.0);
  float rim = border > 0.0 ? clamp(away + border + 0.5, 0.0, 1.0) : 0.0;
  color = mix(fill, border_fill, rim) * cover;
#elif MODE == 1
  color = fill * texture(image, uv).r;
#elif MODE == 2
  color = texture(image, uv) * opacity;
#else
  color = tint * clamp(radius + 0.5 - abs(across), 0.0, 1.0);
#endif
}
#endif

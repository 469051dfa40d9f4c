// Flat items over the picture. Pixels from the top left. MODE: 0 boxes, lines and text masks, 1 a
// picture.

uniform vec2 size;  // of the frame, pixels
uniform sampler2D image;

#ifdef VERTEX
layout(location = 0) in vec2 at;
layout(location = 1) in vec2 own_in;
layout(location = 2) in vec4 fill_in;
layout(location = 3) in vec4 border_fill_in;
layout(location = 4) in vec4 shape_in;
out vec2 own;
out vec4 fill;
flat out vec4 border_fill, shape;
void main() {
  own = own_in;
  fill = fill_in;
  border_fill = border_fill_in;
  shape = shape_in;
  gl_Position = vec4(at.x / size.x * 2.0 - 1.0, 1.0 - at.y / size.y * 2.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
in vec2 own;
in vec4 fill;
flat in vec4 border_fill, shape;  // half width, half height, radius, border; border < 0: a mask
out vec4 color;

void main() {
#if MODE == 0
  vec2 d = abs(own) - shape.xy + shape.z;
  float away = length(max(d, 0.0)) + min(max(d.x, d.y), 0.0) - shape.z;
  float cover = clamp(0.5 - away, 0.0, 1.0);
  if (shape.w < 0.0) cover = texelFetch(image, ivec2(own), 0).r;
  float rim = shape.w > 0.0 ? clamp(away + shape.w + 0.5, 0.0, 1.0) : 0.0;
  color = mix(fill, border_fill, rim) * cover;
#else
  color = texture(image, own) * fill.a;
#endif
}
#endif

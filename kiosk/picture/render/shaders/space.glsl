// The 3-D picture, premultiplied. MODE: 0 one sample a pixel at any scale, 1 many samples at the
// frame's own scale.

uniform vec2 size;  // of the frame, pixels
uniform vec4 box;   // pixels from the lower left
uniform float opacity;
#if MODE == 0
uniform sampler2D space;
#else
uniform sampler2DMS space;
uniform int samples;
#endif

#ifdef VERTEX
layout(location = 0) in vec2 place;
out vec2 uv;
void main() {
  uv = (box.xy + place * box.zw) / size;
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef FRAGMENT
in vec2 uv;
out vec4 color;
void main() {
#if MODE == 0
  color = texture(space, uv) * opacity;
#else
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 over = vec4(0.0);
  for (int i = 0; i < samples; ++i) over += texelFetch(space, pixel, i);
  color = over * (opacity / float(samples));
#endif
}
#endif

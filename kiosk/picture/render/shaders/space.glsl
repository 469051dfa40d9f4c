// The 3-D picture, premultiplied, over the ground. MODE: 0 one sample a pixel at any scale, 1 many
// samples at the frame's own scale.

uniform vec2 size;  // of the frame, pixels
uniform vec4 box;   // pixels from the lower left
uniform sampler2D ground;
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
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#if MODE == 0
  vec4 over = texture(space, uv) * opacity;
#else
  vec4 over = vec4(0.0);
  for (int i = 0; i < samples; ++i) over += texelFetch(space, pixel, i);
  over *= opacity / float(samples);
#endif
  color = vec4(over.rgb + texelFetch(ground, pixel, 0).rgb * (1.0 - over.a), 1.0);
}
#endif

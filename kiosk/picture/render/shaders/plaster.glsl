// The studio's plaster: an even white that gets a little darker away from the window.

uniform vec2 size;
uniform float side;  // where the window is: 1 left .. -1 right

#ifdef VERTEX
layout(location = 0) in vec2 place;
void main() { gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 color;
void main() {
  vec2 p = (gl_FragCoord.xy - 0.5 * size) / min(size.x, size.y);
  vec2 from = p - vec2(-0.25 * side, 0.18);
  float fall = dot(from, from * vec2(0.8, 1.0));
  float light = 1.0 - 0.052 * smoothstep(0.12, 1.5, fall);
  // It also gets warmer: the far wall reflects less blue.
  vec3 plaster = vec3(0.9294, 0.9098, 0.8824) * vec3(light, pow(light, 1.06), pow(light, 1.16));
  color = vec4(dithered(plaster, gl_FragCoord.xy), 1.0);
}
#endif

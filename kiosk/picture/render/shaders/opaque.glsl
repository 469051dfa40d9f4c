// Sets the picture's alpha to 1, wherever the stencil allows.

#ifdef VERTEX
layout(location = 0) in vec2 place;
void main() { gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0); }
#endif

#ifdef FRAGMENT
out vec4 color;
void main() { color = vec4(1.0); }
#endif

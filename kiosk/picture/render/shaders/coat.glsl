// A pot's decoration (coat_texture.h), in front of clay.glsl.

uniform sampler2D coat_rows;  // by share of the height: row of the outer and of the inner wall
#if PART == 0 || PART == 4
uniform sampler2D beads;  // how far clay stands out of the outside, of
uniform float most_bead;  // metres
#endif

vec2 rows_of(float t) {
  float n = float(textureSize(coat_rows, 0).x);
  return between(coat_rows, (t * (n - 1.0) + 0.5) / n, 0.5).rg;
}
#if PART == 0 || PART == 4
float bead_at(float u, float t) {
  return most_bead * textureLod(beads, vec2(u, rows_of(t).x), 0.0).r;
}
#endif

#ifdef FRAGMENT
uniform sampler2D paint;      // root of the light times its cover, cover
uniform sampler2D form;       // slopes along and round, depth, own glaze or polish
uniform vec2 floor_rows;      // of the floor, from the wall to where it ends,
uniform float floor_ends;     // metres from the axis
uniform float coat_level;     // of the textures
uniform float coat_places;    // read at most for a pixel
uniform float own_glaze;      // 1: the glaze that was laid on it melts, 0: the kiln's, all over
uniform float molten;         // 1: slopes and glaze are those of the melt

vec4 painted, shaped;  // of paint and form, here

// Where the wall turns away, a pixel is much longer than wide on the picture: up to coat_places of
// it are read, of a coarser level where it is longer still. Drivers without a GPU have no filter
// for it. A loop, for llvmpipe leaves one early.
void read_coat(vec2 at) {
#ifdef READ
  painted = textureLod(paint, at, coat_level);
  shaped = textureLod(form, at, coat_level);
#else
  vec2 size = vec2(textureSize(paint, int(coat_level)));
  vec2 across = dFdx(at) * size, down = dFdy(at) * size;
  vec2 way = dot(across, across) > dot(down, down) ? across : down;
  float texels = length(way);
  float places = clamp(floor(texels + 0.4), 1.0, coat_places);
  float level = coat_level + (texels > 6.0 && places > 1.0 ? 1.0 : 0.0);
  // The picture's seam is no long pixel.
  vec2 apart = min(texels, 32.0) / max(texels, 1e-6) * way / (size * places);
  vec2 place = at - 0.5 * (places - 1.0) * apart;
  painted = shaped = vec4(0.0);
  for (float n = 0.0; n < places; n += 1.0, place += apart) {
    painted += textureLod(paint, place, level);
    shaped += textureLod(form, place, level);
  }
  painted /= places, shaped /= places;
#endif
}

// Way over the lip from a face to `x` inside it. Its edge is round.
float way_over(float x, float edge) {
  return x < edge ? edge * acos(clamp(1.0 - x / edge, 0.0, 1.0)) : (0.5 * kPi - 1.0) * edge + x;
}
// `ends`: the rows where the lip begins and ends.
float row_on_lip(vec2 ends, float x, float wall, float edge) {
  float half_ = way_over(0.5 * wall, edge);
  float way = x < 0.5 * wall ? way_over(max(x, 0.0), edge)
                             : 2.0 * half_ - way_over(max(wall - x, 0.0), edge);
  return mix(ends.x, ends.y, 0.5 * way / half_);
}
float row_on_floor(float rho, float wall) {
  float way = (wall - rho) / max(wall - floor_ends, 1e-4);
  return mix(floor_rows.x, floor_rows.y, clamp(way, 0.0, 1.0));
}

vec3 over(vec3 below) {
  return below * (1.0 - painted.a) + painted.rgb * painted.rgb / max(painted.a, 1e-3);
}
float polish() { return shaped.a * (1.0 - own_glaze); }

// Slopes of what was cut and laid bend the normal, by their share. Along the outline is a quarter
// turn from the normal, everywhere from the foot to the floor.
vec3 bent(vec3 n, vec3 outward, float share) {
  vec2 slope = share * (shaped.xy * 255.0 - 128.0) / 64.0;
  vec3 along = vec3(-n.y * outward.x, dot(n, outward), -n.y * outward.z);
  return normalize(n - slope.x * along - slope.y * vec3(-outward.z, 0.0, outward.x));
}
#endif

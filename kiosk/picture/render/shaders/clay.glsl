// The clay: a mesh displaced by the radius textures. The mesh is as fine as the picture needs,
// whatever the grid. Its columns stand still in the studio while the texture turns past them, so
// the cut-away discards no pixel. PART: 0 outer wall, 1 lip, 2 inner wall, 3 floor, 4 section of
// floor and wall. SKIN: 0 dry clay, 1 wet clay, 2 glazed, 3 changing to a glaze. Both are fixed
// when the program is compiled: software rasterizers run every branch of a shader, so a scene
// without water compiles none of the wet clay. DECORATED: with paint, cuts and glaze of its own,
// after coat.glsl; a section has its beads alone. READ: writes the surface at given places, without light
// (skin_reader.cpp).

uniform mat4 clip_from_studio;
uniform RADII outer_radius, inner_radius;  // shares of the widest
uniform float widest;
uniform sampler2D grain;
uniform sampler2D row_at;  // by share of the height: share of the rows, and its slope
uniform vec2 grid;  // sectors, rows of the textures
uniform float first_wall_row, top_row, lip_radius, mean_lip;
uniform float height, floor_height, clay_angle, open_from, open_angle, front, pixel;
uniform float mirrored;  // 1: the reflection in the wheel head
uniform vec2 unrolled;   // size of the lip in its own picture (edges.h); 0: in space
uniform float share;     // the drawn share of the outer wall's height, from the foot
uniform float wetness, opened;
uniform float embers;    // 0..1: how bright charcoal glows in the pot
uniform float ink;       // width of the line round the section, m
#if SKIN == 1
uniform sampler2D wet_rows;  // by share of the height
uniform float wet_clay;      // 0: of the slip alone
float wet_at(float t) { return between(wet_rows, t, 0.5).r; }
#else
const float wet_clay = 1.0;
float wet_at(float t) { return 0.0; }
#endif
#if SKIN >= 2
struct Glaze {
  vec3 body, glass, slip, band;
  vec4 lie;     // how slip covers, how it was brushed, how glass pools, gloss
  vec3 band_at; // height and width of the painted band, shares of the height; thickness of the coat
};
uniform Glaze glaze;
#endif
#if SKIN == 3
uniform Glaze glaze_before;
uniform float from_clay, fired, glow;
#endif

float turn_of(float angle) { return (angle - clay_angle) / (2.0 * kPi); }
vec2 rows_at(float t) {
  float n = float(textureSize(row_at, 0).x);
  return between(row_at, (t * (n - 1.0) + 0.5) / n, 0.5).rg;
}
float radius_at(RADII radius, float u, float row) {
  return widest * radius_between(radius, vec2(u, row));
}
float outer_at(float u, float t) { return radius_at(outer_radius, u, rows_at(t).x); }
float inner_at(float u, float t) {
  return radius_at(inner_radius, u, max(rows_at(t).x, first_wall_row));
}

// Of the drawn outside: a bead moves it. Its light comes from the slopes of the coat.
float outside_at(float u, float t) {
#if defined(DECORATED) && (PART == 0 || PART == 4)
  return outer_at(u, t) + bead_at(u, t);
#else
  return outer_at(u, t);
#endif
}

// A potter's wet finger leaves the lip round: half a torus on a thin wall, rounded edges on a thick
// one. Returns how far the rounding goes down at the faces.
float lip_depth(float u) {
  float inner = radius_at(inner_radius, u, top_row);
  float wall = radius_at(outer_radius, u, top_row) - inner;
  return min(lip_radius, inner > 0.0 ? 0.5 * wall : wall);
}
// Height of the lip above that, at `rho` from the axis. The top of a solid lump has only one face.
float lip_rise(float depth, float inner, float outer, float rho) {
  float wall = inner > 0.0 ? outer - inner : 2.0 * outer;
  float x = inner > 0.0 ? min(outer - rho, rho - inner) : outer - rho;
  float edge = min(depth, 0.5 * wall);
  float away = clamp(1.0 - x / max(edge, 1e-6), 0.0, 1.0);
  return depth * sqrt(1.0 - away * away);
}

#ifdef VERTEX
out vec3 position;
out vec2 surface;  // angle in the studio, share of the height
#ifdef READ
layout(location = 0) in vec3 place;  // metres, in the clay's own frame
layout(location = 1) in vec2 texel;  // texel to write

void main() {
  position = place;
  surface = vec2(atan(place.z, place.x == 0.0 && place.z == 0.0 ? 1.0 : place.x), place.y / height);
  gl_Position = vec4(texel, 0.0, 1.0);
  gl_PointSize = 1.0;
}
#else
layout(location = 0) in vec2 place;  // round (or across the wall), along

void main() {
  float round_ = place.x, along = place.y;
#if PART == 4
  float angle = gl_InstanceID == 0 ? front : front - open_angle;
#else
  float angle = open_from + open_angle + round_ * (2.0 * kPi - open_angle);
#endif
  float u = turn_of(angle);
#if PART != 3
  float depth = lip_depth(u), shoulder = height - depth;
#endif
#if PART == 0
  float y = along * share * shoulder;
  float r = outside_at(u, y / height);
#elif PART == 1
  float top_outer = outer_at(u, shoulder / height), top_inner = inner_at(u, shoulder / height);
  float across = 0.5 - 0.5 * cos(kPi * along);  // columns are closer where the lip is round
  float r = mix(top_outer, top_inner, across);
  float y = shoulder + lip_rise(depth, top_inner, top_outer, r);
  // The walls have other columns, so a hem hides the slits between. They are wide where a ring of
  // coil begins beside its end.
  bool inmost = along > 0.999;
  if (along < 0.001 || (inmost && top_inner > 0.0)) {
    const float column = 1.0 / 44.0;  // of the coarsest wall
    float r0 = inmost ? inner_at(u - column, shoulder / height) : outer_at(u - column, shoulder / height);
    float r1 = inmost ? inner_at(u + column, shoulder / height) : outer_at(u + column, shoulder / height);
    y -= 0.0003 + 0.5 * abs(r1 - r0);
  }
#elif PART == 2
  float y = mix(shoulder, min(floor_height, shoulder), along);
  float r = inner_at(u, y / height);
#elif PART == 3
  float y = floor_height;
  // A little into the wall, which has other columns.
  float r = (inner_at(u, 0.0) + 0.0005) * (1.0 - along);
#else
  bool of_floor = along < 0.0;
  float y = of_floor ? (along + 1.0) * floor_height
                     : mix(min(floor_height, shoulder), shoulder, along);
  float outer = outside_at(u, y / height), inner = of_floor ? 0.0 : inner_at(u, y / height);
  float r = mix(inner, outer, 0.5 - 0.5 * cos(kPi * round_));
  y += along > 0.999 ? lip_rise(depth, inner, outer, r) : 0.0;
#endif
  position = vec3(r * cos(angle), y, r * sin(angle));
  surface = vec2(angle, y / height);
  vec3 drawn = mirrored > 0.5 ? vec3(position.x, -position.y, position.z) : position;
  gl_Position = clip_from_studio * vec4(drawn, 1.0);
#if PART == 1
  if (unrolled.x > 0.0) gl_Position = vec4((place - 0.5) * unrolled, 0.0, 1.0);
#endif
}
#endif
#endif

#ifdef FRAGMENT
in vec3 position;
in vec2 surface;
out vec4 color;
#if PART == 4
// Over a whole frame whose picture in space is smaller: the frame's size, the depth by which what is
// nearer hides it, and its opacity. Size 0: in space.
uniform vec4 onto;
uniform sampler2D away;  // depth of the picture in space
#endif

// Normal from the radius gradient by central differences, at the texture's scale or a pixel's if
// that is larger. `bend`: second derivative along the wall (positive in a groove), 1/m.
vec3 normal_of(RADII radius, float u, float t, float low, float side, out float bend) {
  vec2 row = rows_at(t);
  float v = max(row.x, low), metres = height / row.y;  // metres per whole share of rows
  float r = radius_at(radius, u, v);
  float du = max(1.0 / grid.x, 0.7 * pixel / (2.0 * kPi * max(r, 0.01)));
  float dv = max(1.0 / grid.y, 0.7 * pixel / metres);
  float up = min(v + dv, top_row), down = max(v - dv, low);
  float ru = radius_at(radius, u, up), rd = radius_at(radius, u, down);
  float rl = radius_at(radius, u - du, v), rr = radius_at(radius, u + du, v);
  float slope_y = (ru - rd) / max((up - down) * metres, 1e-5);
  float slope_a = (rr - rl) / (2.0 * du * 2.0 * kPi * max(r, 0.002));
  float step_y = max(dv * metres, 1e-5);
  bend = side * (ru + rd - 2.0 * r) / (step_y * step_y);
  vec2 out_dir = vec2(cos(surface.x), sin(surface.x));
  vec2 round_dir = vec2(-out_dir.y, out_dir.x);
  vec2 level = out_dir - slope_a * round_dir;
  return side * normalize(vec3(level.x, -slope_y, level.y));
}

#ifdef DECORATED
// Slip glistens while it is `wet`, and dries matt and paler; a stone polishes it.
Surface decorated(Surface s, float wet) {
  s.albedo = over(s.albedo) * (1.0 - 0.2 * wet * painted.a);
  s.roughness = mix(mix(s.roughness, mix(0.8, 0.12, wet), painted.a), 0.28, polish());
  s.coat = mix(mix(s.coat, mix(0.010, 0.045, wet), painted.a), 0.035, polish());
  return s;
}
#endif

#ifdef TORN
struct Tear {
  float gap;    // metres into an opening; negative outside it
  vec3 normal;  // of the broken clay there
  float depth;  // place in the wall: 0 outer face .. 1 inner face
  float cover;  // share of the pixel that clay covers
};
Tear tear_at(float u, float low, float high, float slope);  // torn.glsl
#endif

#if SKIN >= 2
// A glaze is a coloured glass that runs (Beer-Lambert). It is thick in grooves and towards the
// foot, thin on ridges and the lip, where slip and body show through. The foot ring was wiped
// clean.
Surface of_glaze(Glaze g, float u, float t, float groove, float fleck, float lip, float wiped) {
  float coat = g.band_at.z, pooling = g.lie.z;
  // It draws back from a ridge, and keeps a film there.
  float thick = 0.62 + max(pooling * groove, -0.25) + 0.3 * pooling * (1.0 - t) - 0.5 * lip + 0.12 * fleck;
  if (PART >= 2) thick += 0.33 * pooling * (1.0 - t);
#ifdef DECORATED
  // It melts level, so it is thicker by what was cut away: 0.4 mm is 1, as of a glaze of its own.
  thick += 2.55 * shaped.b * min(1.3 * pooling, 1.0);
  coat *= mix(1.0, 2.55 * shaped.a, own_glaze);
#endif
  thick = coat * clamp(thick, 0.05, 1.8);
  // A coarse brush on the turning pot leaves level streaks.
  float streak = textureLod(grain, vec2(u, position.y * 34.0 + u), 0.0).r;
  float stroke = textureLod(grain, vec2(u, position.y * 7.0 + 2.0 * u), 0.0).r;
  float brushed = mix(1.0, smoothstep(0.20, 0.56, 0.75 * streak + 0.35 * stroke), g.lie.y);
  float cover = g.lie.x * brushed * clamp((thick + 0.02) * 1.9, 0.0, 1.0);
  vec3 under = mix(g.body * (1.0 + 0.07 * fleck), g.slip, cover);
#ifdef DECORATED
  under = over(under);
#else
  if (PART == 0) {
    // Painted by hand: the edges waver, and the brush ran dry here and there.
    float edge = 0.5 * g.band_at.y + 0.0018 * fleck;
    float off = abs(t - g.band_at.x);
    float line = 1.0 - smoothstep(edge - 0.0012, edge + 0.0012, off);
    float fine = 1.0 - smoothstep(0.0018, 0.0032, abs(off - 1.35 * g.band_at.y));
    under = mix(under, g.band, step(1e-4, g.band_at.y) * max(line, 0.85 * fine) * (0.86 + 0.3 * fleck));
  }
#endif
  Surface s;
#ifdef DECORATED
  // Slip scatters light just below the glass, where the body takes some in: it is seen through less.
  thick *= 1.0 - 0.88 * painted.a;
#endif
  s.albedo = under * exp(thick * 1.15 * log(max(g.glass, vec3(1e-4)))) * 0.86;
  float glass = min(coat * 4.0, 1.0) * (1.0 - wiped);
#ifdef DECORATED
  Surface bare = decorated(Surface(g.body * (1.0 + 0.3 * fleck), 0.7, 0.009), 0.0);
  s.albedo = mix(bare.albedo, s.albedo, glass);
  s.roughness = mix(bare.roughness, mix(0.62, 0.07, g.lie.w) + 0.12 * lip, glass);
  s.coat = mix(bare.coat, 0.045, glass);
  return s;
#endif
  s.albedo = mix(s.albedo, g.body * (1.0 + 0.3 * fleck), 1.0 - glass);
  s.roughness = mix(0.7, mix(0.62, 0.07, g.lie.w) + 0.12 * lip, glass);
  s.coat = mix(0.009, 0.045, glass);
  return s;
}
#endif

#ifdef TORN
// Broken clay is rough, and was not wetted like the faces.
Surface of_break(Surface face, float wet, float u) {
  float crumb = textureLod(grain, vec2(u * 9.0, position.y * 40.0), 0.0).r - 0.5;
  Surface s = of_clay(0.4 * wet, 0.0, 1.5 * crumb);
#if SKIN == 2
  s.albedo = mix(glaze.body * (1.0 + 0.3 * crumb), face.albedo, 0.4);
#elif SKIN == 3
  s.albedo = mix(s.albedo, mix(glaze.body, face.albedo, 0.4), fired);
#endif
  s.roughness = 0.85;
  s.coat = 0.009;
  return s;
}
#endif

// `edge`: metres inside it.
vec3 section_color(float u, out float edge) {
  float rho = length(position.xz), t = position.y / height;
  float outer = outside_at(u, t), inner = inner_at(u, t);
  edge = min(outer - rho, position.y);
  float depth = lip_depth(u);
  float top = height - depth + lip_rise(depth, inner, outer, rho);
  edge = min(edge, position.y > floor_height ? min(rho - inner, top - position.y)
                                             : (rho < inner_at(u, 0.0) ? floor_height - position.y : 1.0));
  vec3 clay = mix(dry_color, wet_color, 0.45 * wet_at(t));
#if SKIN == 2
  clay = glaze.body;
#elif SKIN == 3
  clay = mix(mix(glaze_before.body, clay, from_clay), glaze.body, fired);
#endif
  vec3 flat_ = mix(clay, vec3(0.93, 0.80, 0.66), 0.55);
  float fleck = textureLod(grain, vec2(rho, position.y) * 24.0, 0.0).r;
  flat_ *= 0.94 + 0.1 * fleck;
  float inked = ink > 0.0 ? clamp(0.5 + (ink - edge) / pixel, 0.0, 1.0) : 0.0;
  return mix(flat_ * 0.98, vec3(0.017, 0.014, 0.012), 0.9 * inked);
}

void main() {
  float u = turn_of(surface.x), t = clamp(surface.y, 0.0, 1.0);
#if PART == 4
  float edge = 0.0;
  vec3 drawn = section_color(u, edge);
#ifdef TORN
  Tear tear = tear_at(u, inner_at(u, t), outer_at(u, t), 0.0);
  if (tear.gap > 0.0) {
    Surface clay;
    clay.albedo = drawn;
    clay = of_break(clay, wet_at(t), u);
    Seen seen = seen_inside(position, tear.normal, t, clay.albedo, opened);
    drawn = clay.albedo * diffuse_light(tear.normal, seen) * 0.7;
  } else {
    drawn = mix(vec3(0.017, 0.014, 0.012), drawn,
                0.1 + 0.9 * smoothstep(0.8 * pixel, 2.0 * pixel, -tear.gap));
  }
#endif
  color = vec4(dithered(to_display(tone(drawn)), gl_FragCoord.xy), 1.0);
#ifdef TORN
  color.a = tear.cover;
#endif
  if (onto.x > 0.0) {
    ivec2 texel = ivec2(gl_FragCoord.xy / onto.xy * vec2(textureSize(away, 0)));
    if (texelFetch(away, texel, 0).r < gl_FragCoord.z - onto.z) discard;
    color.a *= onto.w * clamp(0.5 + edge / pixel, 0.0, 1.0);
  }
#else
  float bend = 0.0, across = 0.0;
  vec3 n = vec3(0.0, 1.0, 0.0);
  vec3 outward = vec3(cos(surface.x), 0.0, sin(surface.x));
  float rho = length(position.xz);
#if PART == 0
  n = normal_of(outer_radius, u, t, 0.5 / grid.y, 1.0, bend);
#elif PART == 1
  float depth = lip_depth(u);
  float outer = outer_at(u, 1.0 - depth / height), inner = inner_at(u, 1.0 - depth / height);
  across = clamp((rho - inner) / max(outer - inner, 1e-4), 0.0, 1.0) * 2.0 - 1.0;
  float edge = max(min(depth, 0.5 * (outer - inner)), 1e-5);
  float tilt = clamp(1.0 - (outer - rho) / edge, 0.0, 1.0);
  if (inner > 0.0) tilt -= clamp(1.0 - (rho - inner) / edge, 0.0, 1.0);
  n = normalize(outward * tilt * 0.95 + vec3(0.0, sqrt(1.0 - 0.9 * tilt * tilt), 0.0));
#elif PART == 2
  n = normal_of(inner_radius, u, t, first_wall_row, -1.0, bend);
  n = normalize(mix(n, vec3(0.0, 1.0, 0.0),
                    smoothstep(floor_height + 0.004, floor_height, position.y)));
#else
  float rise = smoothstep(0.72, 1.0, rho / max(inner_at(u, 0.0), 1e-4));
  n = normalize(vec3(0.0, 1.0, 0.0) - outward * 0.5 * rise);
#endif

#ifdef DECORATED
#if PART == 0
  vec2 at = vec2(u, rows_of(t).x);
#elif PART == 1
  vec2 at = vec2(u, row_on_lip(rows_of(1.0 - depth / height), outer - rho, outer - inner, edge));
#elif PART == 2
  vec2 at = vec2(u, rows_of(t).y);
#else
  vec2 at = vec2(u, row_on_floor(rho, inner_at(u, 0.0)));
#endif
  read_coat(at);
#ifndef READ
#if SKIN >= 2
  // Glass runs level over it; a melt's own slopes are known.
  float level_ = mix(1.0 - 0.85 * min(4.0 * glaze.band_at.z, 1.0), 1.0, molten);
#endif
#if SKIN == 2
  n = bent(n, outward, level_);
#elif SKIN == 3
  n = bent(n, outward, mix(1.0, level_, fired));
#else
  n = bent(n, outward, 1.0);
#endif
#endif
#endif

#ifdef TORN
#if PART == 1
  Tear tear = tear_at(u, inner, outer, 0.0);
#else
  float wall = max(outer_at(u, t) - inner_at(u, t), 0.0005);
  float slope = (PART == 0 ? -1.0 : 1.0) * n.y / max(length(n.xz), 0.05);
  Tear tear = PART == 0 ? tear_at(u, rho - wall, rho, slope) : tear_at(u, rho, rho + wall, slope);
#endif
  float broken = smoothstep(-0.4 * pixel, 0.4 * pixel, tear.gap);
  // The faces bend inwards near a tear.
  float drawn_in = 0.7 * smoothstep(-0.0022, 0.0, tear.gap);
  n = normalize(mix(n + drawn_in * tear.normal, tear.normal, broken));
#endif

  // The material at this point. `level`: the mipmap level at which a grain texel is a pixel.
  float level = max(log2(pixel * 22.0 * 256.0), 0.0);
  float fleck = textureLod(grain, vec2(u * 6.0, position.y * 22.0 + rho * 9.0), level).r - 0.5;
  float groove = clamp(bend / 900.0, -1.0, 1.0);
#if SKIN < 2
  float wet = wet_at(t);
  Surface skin = of_clay(wet_clay * wet, groove, fleck);
#ifdef DECORATED
  skin = decorated(skin, (1.0 - wet_clay) * smoothstep(0.0, 0.7, wet));
#endif
#else
  float lip = PART == 1 ? 1.0 - 0.75 * across * across
                        : 0.25 * smoothstep(-mean_lip - 0.0016, -mean_lip, position.y - height);
  float wiped = PART == 0 ? 1.0 - smoothstep(0.0042, 0.0056, position.y + 0.0012 * fleck) : 0.0;
  Surface skin = of_glaze(glaze, u, t, groove, fleck, lip, wiped);
#endif
#ifdef READ
  color = vec4(skin.albedo, skin.roughness);
  return;
#endif
#if SKIN == 3
  // The new glaze appears in patches, from the foot up like the kiln's heat.
  Surface before = of_glaze(glaze_before, u, t, groove, fleck, lip, wiped);
  Surface clay = of_clay(0.0, groove, fleck);
#ifdef DECORATED
  clay = decorated(clay, 0.0);
#endif
  float patch_ = textureLod(grain, vec2(u * 2.0, position.y * 3.0), 0.0).r;
  float here = smoothstep(-0.16, 0.16, 1.32 * fired - 0.16 - (0.45 * t + 0.55 * patch_));
  before.albedo = mix(before.albedo, clay.albedo, from_clay);
  before.roughness = mix(before.roughness, clay.roughness, from_clay);
  before.coat = mix(before.coat, clay.coat, from_clay);
  skin.albedo = mix(before.albedo, skin.albedo, here);
  skin.roughness = mix(before.roughness, skin.roughness, here);
  skin.coat = mix(before.coat, skin.coat, here);
#endif

#ifdef TORN
  // Near a tear the clay was stretched until it cracked.
  float crack = abs(textureLod(grain, vec2(u + 0.5, position.y * 4.5), 0.0).r - 0.5);
  crack = (1.0 - smoothstep(0.01, 0.08, crack)) * smoothstep(-0.0040, -0.0005, tear.gap);
  skin.albedo *= 1.0 - 0.42 * crack;
  Surface raw = of_break(skin, wet_at(t), u);
  skin.albedo = mix(skin.albedo, raw.albedo, broken);
  skin.roughness = mix(skin.roughness, raw.roughness, max(broken, 0.6 * drawn_in));
  skin.coat = mix(skin.coat, raw.coat, broken);
#endif

#if PART >= 2
  Seen s = seen_inside(position, n, t, skin.albedo, opened);
#else
  Seen s = seen_outside(position, n, t);
  // Near the foot the pot shades its own wheel head, which then reflects little light.
  s.sky *= 1.0 - 0.55 * exp(-max(position.y, 0.0) / 0.011) * (0.6 - 0.4 * n.y);
  if (PART == 1) s.sky = 1.0;
#endif
#ifdef TORN
  // Little light enters a crack, least half-way through.
  float hidden = 1.0 - broken * (0.12 + 1.3 * tear.depth * (1.0 - tear.depth)) * (1.0 - 0.6 * n.y);
  s.sky *= hidden;
  s.window *= hidden;
#endif
  vec3 v = normalize(eye - position);
  vec3 lit = skin.albedo * diffuse_light(n, s);
  lit += specular(n, v, skin.roughness, skin.coat, s.sky * (PART >= 2 ? s.sky : 1.0), s.window);
#if PART >= 2 && SKIN < 2
  // Embers hang at the axis, as a light the size of a fist.
  const vec3 kEmbers = vec3(0.0052, 0.0014, 0.0002);
  const float kFist = 0.03;
  vec3 way = vec3(0.0, mix(floor_height, height, 0.4), 0.0) - position;
  float far = dot(way, way);
  lit += skin.albedo * kEmbers * (embers * wrapped(dot(n, way) * inversesqrt(far)) / (far + kFist * kFist));
#endif
#if SKIN == 3
  // At 1200 degrees a pot glows by itself. Hollows look brightest, because most light from their
  // own walls reaches them.
  float hollow = PART >= 2 ? 1.3 : 1.0 - 0.35 * clamp(dot(n, v), 0.0, 1.0);
  lit = lit * (1.0 - 0.6 * glow) +
        vec3(0.74, 0.150, 0.020) * glow * glow * hollow * (1.0 + 0.35 * groove);
#endif
  color = vec4(dithered(to_display(tone(lit)), gl_FragCoord.xy), 1.0);
#ifdef TORN
  color.a = tear.cover;
#endif
  // The wheel head reflects only what is near it, and more when it is wet.
  color *= mirrored > 0.5 ? exp(-position.y / 0.035) * (0.07 + 0.23 * wetness) : 1.0;
#endif
}
#endif

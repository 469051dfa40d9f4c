// Torn rings: ragged openings in the wall, and the broken clay round them. Follows clay.glsl, in
// separate programs (TORN), so that a whole pot does not pay for it.

#ifdef FRAGMENT
uniform float soft_edges;   // 1: alpha is the share of the pixel that clay covers
uniform sampler2D torn_at;  // by share of the height: metres into torn rings, negative outside

// How far a point of the wall is inside an opening, metres; negative in clay. The engine tears
// whole rings. Here bridges hold the wall together, so that it can be seen to stand.
float gap_at(float u, float y) {
  float a = 2.0 * kPi * u;
  // A tear wanders up and down,
  float at = y + 0.0014 * sin(3.0 * a + 1.0) + 0.0009 * sin(7.0 * a + 2.6);
  float n = float(textureSize(torn_at, 0).x);
  float t = clamp(at / height, 0.0, 1.0);
  float ring = between(torn_at, (t * (n - 1.0) + 0.5) / n, 0.5).r;
  // gapes here and closes there,
  float gape = 0.5 * sin(2.0 * a + 0.6 + 31.0 * y) + 0.5 * sin(3.0 * a + 2.1 - 47.0 * y) +
               0.6 * sin(5.0 * a + 4.0 + 23.0 * y) + 0.4 * sin(8.0 * a + 1.0);
  gape = min(0.0046 * (gape + 0.28), 0.0044);
  // and its edges are rough.
  float coarse = textureLod(grain, vec2(u, y * 3.0), 0.0).r - 0.5;
  float fine = textureLod(grain, vec2(u * 2.0, y * 6.0), 0.0).r - 0.5;
  float gap = min(ring, 0.0016) + gape + 0.0027 * coarse + 0.0008 * fine;
  return min(gap, at - floor_height - 0.002);
}

// Follows the view into the opening at `position`, on a face or section of the wall, until it meets
// broken clay. If there is none, the eye sees through. `low` and `high` are the wall's faces there,
// which widen by `slope` with height.
Tear tear_at(float u, float low, float high, float slope) {
  Tear tear;
  tear.gap = gap_at(u, position.y);
  tear.normal = vec3(0.0);
  tear.depth = 0.0;
  tear.cover = 1.0;
  vec3 way = normalize(position - eye);
  float rho = max(length(position.xz), 1e-4);
  vec3 outward = vec3(position.x, 0.0, position.z) / rho;
  vec3 round_ = vec3(-outward.z, 0.0, outward.x);
  float around = dot(way, round_) / (2.0 * kPi * rho);
  float wall = max(high - low, 0.001);
  // Along the wall the way through is long.
  float step_ = clamp(0.14 * wall / max(abs(dot(way, outward)), 0.1), 0.0003, 0.0035);
  float gone = 0.0, here = tear.gap, nearest = here;
  for (int i = 0; i < 12 && here > 0.0; ++i) {
    gone += step_;
    vec3 p = position + gone * way;
    float out_ = length(p.xz), widened = slope * (p.y - position.y);
    if (out_ > high + widened + 2e-5 || out_ < low + widened - 2e-5) break;
    here = gap_at(u + gone * around, p.y);
    nearest = min(nearest, here);
    tear.depth = clamp((high + widened - out_) / wall, 0.0, 1.0);
  }
  tear.cover = clamp(1.0 - nearest / pixel, 0.0, 1.0);
  if (tear.cover <= (soft_edges > 0.5 ? 0.0 : 0.5)) discard;
  if (soft_edges < 0.5) tear.cover = 1.0;
  // Broken clay faces the opening.
  float v = u + gone * around, y = position.y + gone * way.y;
  const float e = 0.0006;
  float up = gap_at(v, y + e) - gap_at(v, y - e);
  float on = gap_at(v + e / (2.0 * kPi * rho), y) - gap_at(v - e / (2.0 * kPi * rho), y);
  tear.normal = normalize(vec3(0.0, up, 0.0) + round_ * on - 0.0006 * way);
  return tear;
}
#endif

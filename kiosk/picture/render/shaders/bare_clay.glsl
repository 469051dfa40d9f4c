// Clay without slip or glaze, before what draws it.

uniform vec3 dry_color, wet_color;

struct Surface {
  vec3 albedo;
  float roughness, coat;
};

// Wet clay is darker and shines under an even film of water, which hides its grain. Ridges dry
// first, so the throwing lines show while the film goes.
Surface of_clay(float wet, float groove, float fleck) {
  wet = clamp(wet + 0.7 * groove * wet * (1.0 - wet), 0.0, 1.0);
  float film = smoothstep(0.0, 0.8, wet), grain_ = fleck * (1.0 - 0.85 * film);
  Surface s;
  s.albedo = mix(dry_color, wet_color, wet) * (1.0 + 0.16 * grain_) * (1.0 - 0.16 * groove);
  s.roughness = mix(0.78, 0.25, film);
  s.coat = mix(0.012, 0.045, film);
  return s;
}

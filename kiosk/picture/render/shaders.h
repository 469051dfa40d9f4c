#pragma once

namespace onggi::render {

/// The files of kiosk/picture/render/shaders, compiled in. Each program's file has its vertex stage
/// under `#ifdef VERTEX` and its fragment stage under `#ifdef FRAGMENT`.
extern const char* const k_common_glsl;     ///< Colour, tone, dither: before every program.
extern const char* const k_light_glsl;      ///< The studio's light on a vessel of revolution.
extern const char* const k_bare_clay_glsl;  ///< Before clay.glsl and coil.glsl.
extern const char* const k_coat_glsl;       ///< Before clay.glsl, if the pot is decorated.
extern const char* const k_clay_glsl;
extern const char* const k_coil_glsl;
extern const char* const k_tool_glsl;
extern const char* const k_torn_glsl;  ///< After clay.glsl, if rings are torn.
extern const char* const k_solid_glsl;
extern const char* const k_space_glsl;
extern const char* const k_wheel_glsl;
extern const char* const k_shadow_glsl;
extern const char* const k_ground_glsl;
extern const char* const k_opaque_glsl;
extern const char* const k_plaster_glsl;
extern const char* const k_item_glsl;
extern const char* const k_edge_glsl;

}  // namespace onggi::render

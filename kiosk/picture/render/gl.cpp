#include "kiosk/picture/render/gl.h"

#include <vector>

namespace onggi::render {
namespace {

GLenum mode_of(Mesh::Of of) {
  return of == Mesh::Of::strip    ? GL_TRIANGLE_STRIP
         : of == Mesh::Of::points ? GL_POINTS
                                  : GL_TRIANGLES;
}

GLuint new_texture() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return name;
}

Result<GLuint> compile(GLenum stage, const std::string& name, const std::string& source) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint fine = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &fine);
  if (fine == GL_TRUE) return shader;
  char log[2000] = {};
  glGetShaderInfoLog(shader, sizeof log - 1, nullptr, log);
  glDeleteShader(shader);
  return problem("shader " + name, std::string("The graphics driver does not accept it: ") + log,
                 "Update the graphics driver, or run with LIBGL_ALWAYS_SOFTWARE=1.", 1);
}

}  // namespace

Result<Program> Program::create(const std::string& name, std::initializer_list<const char*> parts) {
  std::string body;
  for (const char* part : parts) body += part;
  // Vertex and fragment stage must agree about uniforms' precision, and pixel coordinates reach
  // thousands.
  static const std::string kEmbedded =
      "#version 310 es\n"
      "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
      "precision highp usampler2D;\nprecision highp sampler2DMS;\n#define ";
  const std::string head = embedded() ? kEmbedded : "#version 330 core\n#define ";
  const auto vertex = compile(GL_VERTEX_SHADER, name, head + "VERTEX\n" + body);
  if (!vertex) return tl::unexpected(vertex.error());
  const auto fragment = compile(GL_FRAGMENT_SHADER, name, head + "FRAGMENT\n" + body);
  if (!fragment) {
    glDeleteShader(*vertex);
    return tl::unexpected(fragment.error());
  }
  Program program;
  program.name_ = ProgramName(glCreateProgram());
  const GLuint id = program.name_.get();
  glAttachShader(id, *vertex);
  glAttachShader(id, *fragment);
  glLinkProgram(id);
  glDeleteShader(*vertex);
  glDeleteShader(*fragment);
  GLint fine = GL_FALSE;
  glGetProgramiv(id, GL_LINK_STATUS, &fine);
  if (fine == GL_TRUE) return program;
  char log[2000] = {};
  glGetProgramInfoLog(id, sizeof log - 1, nullptr, log);
  return problem("shader " + name, std::string("The graphics driver does not link it: ") + log,
                 "Update the graphics driver, or run with LIBGL_ALWAYS_SOFTWARE=1.", 1);
}

GLint Program::at(const char* uniform) const {
  const auto found = places_.find(uniform);
  if (found != places_.end()) return found->second;
  return places_[uniform] = glGetUniformLocation(name_.get(), uniform);
}

Texture Texture::create(GLint internal, int width, int height, GLenum format, GLenum type,
                        const void* pixels) {
  Texture t{TextureName(new_texture()), width, height};
  calls::bind_texture(t.name.get());
  calls::texture_image(0, internal, width, height, format, type, pixels);
  const bool by_hand =
      embedded() && (type == GL_FLOAT || format == GL_RED_INTEGER) && internal != GL_RGB16F;
  const GLint filter = by_hand ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return t;
}

Target::Target(int width, int height, bool depth, int samples) : width_(width), height_(height) {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  framebuffer_ = FramebufferName(name);
  calls::bind_framebuffer(GL_FRAMEBUFFER, name);
  if (samples > 0) {
    sampled_ = TextureName(new_texture());
    bind_samples(0);
    calls::texture_samples(samples, GL_RGBA8, width, height);
    // A driver may choose more samples than requested.
    glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_SAMPLES, &samples_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE,
                           sampled_.get(), 0);
  } else {
    color_ = Texture::create(GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name.get(),
                           0);
  }
  if (!depth) return;
  if (samples > 0) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    sampled_depth_ = RenderbufferName(buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH24_STENCIL8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffer);
  } else {
    depth_ = Texture::create(GL_DEPTH24_STENCIL8, width, height, GL_DEPTH_STENCIL,
                             GL_UNSIGNED_INT_24_8, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                           depth_.name.get(), 0);
  }
}

void Target::bind() const {
  calls::bind_framebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glViewport(0, 0, width_, height_);
}

void Target::resolve_to(const Target& to) const {
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, framebuffer_.get());
  calls::bind_framebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer());
  calls::copy(0, 0, width_, height_);
}

Mesh::Mesh(const float* vertices, std::size_t floats, const std::uint32_t* indices,
           std::size_t index_count, std::initializer_list<int> attributes, Of of)
    : count_(static_cast<int>(index_count)), of_(of) {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  array_ = ArrayName(name);
  calls::bind_array(name);
  glGenBuffers(1, &name);
  vertices_ = BufferName(name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  calls::buffer_data(GL_ARRAY_BUFFER, floats * sizeof(float), vertices, GL_STATIC_DRAW);
  glGenBuffers(1, &name);
  indices_ = BufferName(name);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
  calls::buffer_data(GL_ELEMENT_ARRAY_BUFFER, index_count * sizeof(std::uint32_t), indices,
                     GL_STATIC_DRAW);
  int stride = 0;
  for (const int size : attributes) stride += size;
  GLuint location = 0;
  std::size_t offset = 0;
  for (const int size : attributes) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location++, size, GL_FLOAT, GL_FALSE,
                          stride * static_cast<int>(sizeof(float)),
                          reinterpret_cast<const void*>(offset));
    offset += static_cast<std::size_t>(size) * sizeof(float);
  }
}

void Mesh::draw_some(int first, int count) const {
  calls::bind_array(array_.get());
  calls::draw_elements(mode_of(of_), count, GL_UNSIGNED_INT, static_cast<std::size_t>(first));
}

void Mesh::draw_times(int times) const {
  calls::bind_array(array_.get());
  calls::draw_elements_times(mode_of(of_), count_, GL_UNSIGNED_INT, times);
}

int indices_of_rows(int columns, int rows) {
  return rows < 1 ? 0 : 1 + rows * 2 * (columns + 1) + 2 * (rows - 1);
}

Mesh unit_grid(int columns, int rows) {
  std::vector<float> places;
  std::vector<std::uint32_t> indices;
  const auto across = static_cast<std::uint32_t>(columns + 1);
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      places.push_back(static_cast<float>(x) / static_cast<float>(columns));
      places.push_back(static_cast<float>(y) / static_cast<float>(rows));
    }
  }
  // The first vertex is repeated, so that triangles are wound like (a, b, b + 1), with a below b,
  // and two triangles without area lie between rows.
  indices.push_back(across);
  for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(rows); ++y) {
    if (y > 0) indices.insert(indices.end(), {indices.back(), (y + 1) * across});
    for (std::uint32_t x = 0; x < across; ++x)
      indices.insert(indices.end(), {(y + 1) * across + x, y * across + x});
  }
  return Mesh(places.data(), places.size(), indices.data(), indices.size(), {2}, Mesh::Of::strip);
}

std::vector<std::uint32_t> disc_indices(std::uint32_t corners) {
  // A triangle in the middle; the rest of the circle on each of its sides is halved again and
  // again.
  const std::uint32_t third = corners / 3;
  std::vector<std::uint32_t> indices{0, third, 2 * third};
  for (std::uint32_t step = third; step > 1; step /= 2)
    for (std::uint32_t from = 0; from < corners; from += step)
      indices.insert(indices.end(), {from, from + step / 2, (from + step) % corners});
  return indices;
}

}  // namespace onggi::render

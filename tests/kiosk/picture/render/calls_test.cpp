#include "kiosk/picture/render/calls.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/ground/files/scratch_folder.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing::calls_test {
namespace {

namespace fs = std::filesystem;

// The count is whole as long as nothing goes past it.
TEST(Calls, NoOtherFileDrawsUploadsCopiesOrSwitches) {
  const std::regex counted(
      R"(\bgl(Draw[A-Z]\w*|MultiDraw\w*|Buffer(Sub)?Data|BufferStorage|MapBuffer\w*|CopyBuffer\w*|)"
      R"((Compressed)?Tex(Sub)?Image\w*|TexStorage\w*|CopyTex\w*|CopyImage\w*|DrawPixels|)"
      R"(NamedBuffer\w*|Texture(Sub)?Image\w*|BlitFramebuffer|BlitNamedFramebuffer|UseProgram|)"
      R"(BindTexture\w*|BindVertexArray|BindFramebuffer)\s*\()");
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator("kiosk")) {
    const fs::path& file = entry.path();
    if (file.extension() != ".cpp" && file.extension() != ".h") continue;
    ++files;
    const std::string text = files::test::content(file);
    const bool found = std::regex_search(text, counted);
    EXPECT_EQ(found, file == "kiosk/picture/render/calls.cpp") << file;
  }
  EXPECT_GT(files, 100);
}

// What GL itself was asked, heard where the program calls it.
FrameWork heard;

decltype(epoxy_glDrawElements) draw_elements;
decltype(epoxy_glDrawElementsInstanced) draw_elements_instanced;
decltype(epoxy_glDrawArrays) draw_arrays;
decltype(epoxy_glBufferData) buffer_data;
decltype(epoxy_glBufferSubData) buffer_part;
decltype(epoxy_glTexImage2D) texture_image;
decltype(epoxy_glTexSubImage2D) texture_part;
decltype(epoxy_glBlitFramebuffer) copy;
decltype(epoxy_glUseProgram) use_program;
decltype(epoxy_glBindTexture) bind_texture;
decltype(epoxy_glBindVertexArray) bind_array;
decltype(epoxy_glBindFramebuffer) bind_framebuffer;

std::uint64_t size_of(GLsizei w, GLsizei h, GLenum format, GLenum type, const void* pixels) {
  if (pixels == nullptr) return 0;
  const int channels = format == GL_RED || format == GL_RED_INTEGER ? 1
                       : format == GL_RG                            ? 2
                       : format == GL_RGB                           ? 3
                                                                    : 4;
  const int each = type == GL_FLOAT ? 4 : type == GL_UNSIGNED_SHORT ? 2 : 1;
  EXPECT_TRUE(type == GL_FLOAT || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_BYTE) << type;
  return static_cast<std::uint64_t>(w) * static_cast<std::uint64_t>(h * channels * each);
}

/// Hears every call that counts while it lives.
class Ear {
 public:
  Ear() {
    heard = {};
    // The first call of each finds the driver's own.
    glBindVertexArray(0);
    glUseProgram(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDrawArrays(GL_TRIANGLES, 0, 0);
    glDrawElements(GL_TRIANGLES, 0, GL_UNSIGNED_INT, nullptr);
    glDrawElementsInstanced(GL_TRIANGLES, 0, GL_UNSIGNED_INT, nullptr, 0);
    glBufferData(GL_ARRAY_BUFFER, 0, nullptr, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, 0, nullptr);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, 0, 0, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 0, 0, 0, 0, 0, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    while (glGetError() != GL_NO_ERROR) {
    }
    draw_elements = std::exchange(epoxy_glDrawElements,
                                  [](GLenum mode, GLsizei count, GLenum type, const void* at) {
                                    ++heard.draws;
                                    heard.vertices += static_cast<std::uint64_t>(count);
                                    draw_elements(mode, count, type, at);
                                  });
    draw_elements_instanced = std::exchange(
        epoxy_glDrawElementsInstanced,
        [](GLenum mode, GLsizei count, GLenum type, const void* at, GLsizei times) {
          ++heard.draws;
          heard.vertices += static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(times);
          draw_elements_instanced(mode, count, type, at, times);
        });
    draw_arrays = std::exchange(epoxy_glDrawArrays, [](GLenum mode, GLint first, GLsizei count) {
      ++heard.draws;
      heard.vertices += static_cast<std::uint64_t>(count);
      draw_arrays(mode, first, count);
    });
    buffer_data = std::exchange(epoxy_glBufferData,
                                [](GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
                                  if (data != nullptr)
                                    heard.bytes += static_cast<std::uint64_t>(size);
                                  buffer_data(target, size, data, usage);
                                });
    buffer_part = std::exchange(epoxy_glBufferSubData,
                                [](GLenum target, GLintptr at, GLsizeiptr size, const void* data) {
                                  heard.bytes += static_cast<std::uint64_t>(size);
                                  buffer_part(target, at, size, data);
                                });
    texture_image = std::exchange(
        epoxy_glTexImage2D, [](GLenum target, GLint level, GLint internal, GLsizei w, GLsizei h,
                               GLint border, GLenum format, GLenum type, const void* pixels) {
          heard.bytes += size_of(w, h, format, type, pixels);
          texture_image(target, level, internal, w, h, border, format, type, pixels);
        });
    texture_part = std::exchange(epoxy_glTexSubImage2D,
                                 [](GLenum target, GLint level, GLint x, GLint y, GLsizei w,
                                    GLsizei h, GLenum format, GLenum type, const void* pixels) {
                                   heard.bytes += size_of(w, h, format, type, pixels);
                                   texture_part(target, level, x, y, w, h, format, type, pixels);
                                 });
    copy = std::exchange(
        epoxy_glBlitFramebuffer, [](GLint x0, GLint y0, GLint x1, GLint y1, GLint a0, GLint b0,
                                    GLint a1, GLint b1, GLbitfield mask, GLenum filter) {
          heard.copied += static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
          copy(x0, y0, x1, y1, a0, b0, a1, b1, mask, filter);
        });
    use_program = std::exchange(epoxy_glUseProgram, [](GLuint name) {
      ++heard.switches;
      use_program(name);
    });
    bind_texture = std::exchange(epoxy_glBindTexture, [](GLenum target, GLuint name) {
      ++heard.switches;
      bind_texture(target, name);
    });
    bind_array = std::exchange(epoxy_glBindVertexArray, [](GLuint name) {
      ++heard.switches;
      bind_array(name);
    });
    bind_framebuffer = std::exchange(epoxy_glBindFramebuffer, [](GLenum target, GLuint name) {
      ++heard.switches;
      bind_framebuffer(target, name);
    });
  }
  ~Ear() {
    epoxy_glDrawElements = draw_elements;
    epoxy_glDrawElementsInstanced = draw_elements_instanced;
    epoxy_glDrawArrays = draw_arrays;
    epoxy_glBufferData = buffer_data;
    epoxy_glBufferSubData = buffer_part;
    epoxy_glTexImage2D = texture_image;
    epoxy_glTexSubImage2D = texture_part;
    epoxy_glBlitFramebuffer = copy;
    epoxy_glUseProgram = use_program;
    epoxy_glBindTexture = bind_texture;
    epoxy_glBindVertexArray = bind_array;
    epoxy_glBindFramebuffer = bind_framebuffer;
  }
};

double jar(double t) { return 0.04 + 0.02 * t; }

using FrameWorkOf = StudioTest;

TEST_F(FrameWorkOf, EveryKindOfFrameIsWhatGlWasAsked) {
  view::Frame frame = frame_with_pot(640, 400, 0.15, 0.06);
  frame.pot->hands[0] = {.present = true, .radius = 0.01, .at = {0.08, 0.1, 0}};
  frame.pot->wetness_by_row = {0.0f, 0.5f, 1.0f};
  frame.items.emplace_back(view::Box{{10, 10, 40, 30}, 5, view::kCobalt, 0, {}});
  frame.items.emplace_back(view::Text{{10, 60, 200, 60}, "counted", {}, view::kInk});
  frame.items.emplace_back(view::Line{{{10, 200}, {40, 220}, {90, 210}}, {view::kIron}, 3});
  const ClayView clay = thrown_clay(grid_of(120, 96, 0.15, 0.01), jar, 0.006, 0.0005);
  const ClayView other = thrown_clay(grid_of(120, 96, 0.15, 0.01), jar, 0.004, 0.0);
  renderer().draw(frame);

  const Ear ear;
  const FrameWork before = renderer().status().work;
  renderer().show_clay(clay);
  renderer().draw(frame);
  frame.pot->cut_away = 0.7;
  renderer().show_clay(other);
  renderer().draw(frame);
  frame.screen_serial = 9;
  frame.fade = 0.5f;
  renderer().draw(frame);
  frame.pot->finish = view::Finish::fired;
  const view::PictureId picture =
      renderer().make_picture(view::Image{2, 2, std::vector<std::uint8_t>(16, 255)});
  frame.items.emplace_back(view::Picture{{300, 10, 40, 40}, picture, 1});
  renderer().draw(frame);
  renderer().present();
  renderer().read_pixels();
  renderer().draw_offscreen(frame);
  EXPECT_EQ(renderer().status().work - before, heard);
  EXPECT_GT(heard.draws, 30u);
  EXPECT_GT(heard.bytes, 2u * 120 * 96 * 2);
  EXPECT_GT(heard.copied, 640u * 400);
  renderer().drop_picture(picture);
}

TEST_F(FrameWorkOf, AStillOneIsNothing) {
  view::Frame frame = frame_with_pot(640, 400, 0.15, 0.06);
  renderer().show_clay(thrown_clay(grid_of(120, 96, 0.15, 0.01), jar, 0.006, 0.0005));
  renderer().draw(frame);
  const FrameWork before = renderer().status().work;
  renderer().draw(frame);
  EXPECT_EQ(renderer().status().work - before, FrameWork{});
}

// A plaster with one box on it: the driver's count has every pixel of both.
TEST_F(FrameWorkOf, ShadersAreCountedOnlyWhenAsked) {
  if (!renderer().status().shading_counted) GTEST_SKIP() << "this driver counts no shader runs";
  view::Frame frame;
  frame.width = 640;
  frame.height = 400;
  frame.items.emplace_back(view::Box{{0, 0, 640, 400}, 0, view::kCobalt, 0, {}});
  const FrameWork before = renderer().status().work;
  renderer().draw(frame);
  EXPECT_EQ((renderer().status().work - before).fragment_runs, 0u);
  renderer().count_shading(true);
  frame.items.emplace_back(view::Box{{0, 0, 640, 200}, 0, view::kIron, 0, {}});
  renderer().draw(frame);
  renderer().count_shading(false);
  const FrameWork work = renderer().status().work - before;
  EXPECT_GE(work.fragment_runs, 640u * 600);
  EXPECT_GE(work.vertex_runs, 8u);
  EXPECT_LT(work.vertex_runs, 100u);
}

}  // namespace
}  // namespace onggi::render::testing::calls_test

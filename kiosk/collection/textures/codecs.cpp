#include "kiosk/collection/textures/codecs.h"

#include <csetjmp>
#include <cstdio>
#include <cstring>

// jpeglib.h needs FILE and size_t before it.
#include <jerror.h>
#include <jpeglib.h>
#include <png.h>
#include <webp/decode.h>

namespace onggi::textures {
namespace {

tl::unexpected<std::string> damaged(const std::string& why) {
  return tl::unexpected("it is damaged" + (why.empty() ? "" : ": " + why.substr(0, 120)));
}

TexturePixels canvas(std::size_t width, std::size_t height) {
  TexturePixels out;
  out.width = static_cast<int>(width);
  out.height = static_cast<int>(height);
  out.rgb.resize(3 * width * height);
  return out;
}

/// libpng and libjpeg report faults with longjmp, so no object with a destructor is made between
/// setjmp() and it; all of those are members.
class PngFile {
 public:
  explicit PngFile(std::span<const std::uint8_t> bytes) : rest_(bytes) {
    png_ =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, const char*) {});
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  ~PngFile() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  bool head() {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_user_limits(png_, 0x7fffffff, 0x7fffffff);  // we check and report our own limits
    png_set_read_fn(png_, this, read);
    png_read_info(png_, info_);
    return true;
  }
  std::uint64_t width() const { return png_get_image_width(png_, info_); }
  std::uint64_t height() const { return png_get_image_height(png_, info_); }

  bool pixels(TexturePixels& into) {
    rows_.resize(static_cast<std::size_t>(into.height));
    for (std::size_t y = 0; y < rows_.size(); ++y)
      rows_[y] = into.rgb.data() + 3 * y * static_cast<std::size_t>(into.width);
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand(png_);
    png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_strip_alpha(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    if (png_get_rowbytes(png_, info_) != 3 * static_cast<std::size_t>(into.width))
      png_error(png_, "its rows are of another length");
    png_read_image(png_, rows_.data());
    png_read_end(png_, nullptr);
    return true;
  }
  const std::string& fault() const { return fault_; }

 private:
  static void fail(png_structp png, const char* why) {
    static_cast<PngFile*>(png_get_error_ptr(png))->fault_ = why;
    longjmp(png_jmpbuf(png), 1);
  }
  static void read(png_structp png, png_bytep to, std::size_t size) {
    auto& rest = static_cast<PngFile*>(png_get_io_ptr(png))->rest_;
    if (size > rest.size()) png_error(png, "it ends too early");
    std::memcpy(to, rest.data(), size);
    rest = rest.subspan(size);
  }

  std::span<const std::uint8_t> rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<png_bytep> rows_;
  std::string fault_;
};

class JpegFile {
 public:
  explicit JpegFile(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
    file_.err = jpeg_std_error(&errors_);
    file_.client_data = this;
    errors_.error_exit = fail;
    errors_.emit_message = note;
    progress_.progress_monitor = watch;
  }
  ~JpegFile() { jpeg_destroy_decompress(&file_); }
  JpegFile(const JpegFile&) = delete;
  JpegFile& operator=(const JpegFile&) = delete;

  bool head() {
    if (setjmp(back_) != 0) return false;
    jpeg_create_decompress(&file_);
    file_.progress = &progress_;
    jpeg_mem_src(&file_, bytes_.data(), static_cast<unsigned long>(bytes_.size()));
    jpeg_read_header(&file_, TRUE);
    return true;
  }
  std::uint64_t width() const { return file_.image_width; }
  std::uint64_t height() const { return file_.image_height; }
  bool printed() const { return file_.num_components == 4; }

  bool pixels(TexturePixels& into) {
    if (setjmp(back_) != 0) return false;
    file_.out_color_space = JCS_RGB;
    jpeg_start_decompress(&file_);
    while (file_.output_scanline < file_.output_height) {
      JSAMPROW row = into.rgb.data() +
                     3 * static_cast<std::size_t>(file_.output_scanline) * file_.output_width;
      jpeg_read_scanlines(&file_, &row, 1);
    }
    jpeg_finish_decompress(&file_);
    return true;
  }
  const std::string& fault() const { return fault_; }

 private:
  static constexpr int kMostScans = 100;  // a camera's progressive file has ten

  static void fail(j_common_ptr file) {
    auto& self = *static_cast<JpegFile*>(file->client_data);
    char words[JMSG_LENGTH_MAX];
    file->err->format_message(file, words);
    self.fault_ = words;
    longjmp(self.back_, 1);
  }
  /// libjpeg fills missing or wrong data with grey and only warns. Extra bytes between two parts
  /// are harmless, and scanners write them.
  static void note(j_common_ptr file, int level) {
    if (level >= 0 || file->err->msg_code == JWRN_EXTRANEOUS_DATA ||
        file->err->msg_code == JWRN_ADOBE_XFORM)
      return;
    fail(file);
  }
  static void watch(j_common_ptr file) {
    auto& self = *static_cast<JpegFile*>(file->client_data);
    if (self.file_.input_scan_number <= kMostScans) return;
    self.fault_ = "it has more than a hundred scans";
    longjmp(self.back_, 1);
  }

  std::span<const std::uint8_t> bytes_;
  jpeg_decompress_struct file_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  std::jmp_buf back_;
  std::string fault_;
};

}  // namespace

std::optional<std::string> fault_of_size(std::uint64_t width, std::uint64_t height, unsigned most) {
  if (width == 0 || height == 0) return "it has no pixels";
  if (width <= most && height <= most) return std::nullopt;
  return "it has " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels, but the limit for its longest side is " + std::to_string(most) +
         ": scale it down, or raise texture_px in the exhibit's [reader]";
}

Decoded decode_png(std::span<const std::uint8_t> bytes, unsigned most_side) {
  // The first chunk has the size, after eight bytes of signature and eight of its own. libpng would
  // unpack texts and profiles before it gives the size.
  const auto side = [&bytes](std::size_t at) {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i) out = out << 8 | bytes[at + i];
    return out;
  };
  if (bytes.size() < 24) return damaged("it ends too early");
  if (auto fault = fault_of_size(side(16), side(20), most_side)) return tl::unexpected(*fault);
  PngFile file(bytes);
  if (!file.head()) return damaged(file.fault());
  if (auto fault = fault_of_size(file.width(), file.height(), most_side))
    return tl::unexpected(*fault);
  TexturePixels out = canvas(file.width(), file.height());
  if (!file.pixels(out)) return damaged(file.fault());
  return out;
}

Decoded decode_jpeg(std::span<const std::uint8_t> bytes, unsigned most_side) {
  JpegFile file(bytes);
  if (!file.head()) return damaged(file.fault());
  if (auto fault = fault_of_size(file.width(), file.height(), most_side))
    return tl::unexpected(*fault);
  if (file.printed()) return tl::unexpected(std::string("it is in printers' colours (CMYK)"));
  TexturePixels out = canvas(file.width(), file.height());
  if (!file.pixels(out)) return damaged(file.fault());
  return out;
}

Decoded decode_webp(std::span<const std::uint8_t> bytes, unsigned most_side) {
  WebPBitstreamFeatures head;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &head) != VP8_STATUS_OK)
    return damaged("its header");
  if (auto fault = fault_of_size(static_cast<std::uint64_t>(head.width),
                                 static_cast<std::uint64_t>(head.height), most_side))
    return tl::unexpected(*fault);
  if (head.has_animation != 0) return tl::unexpected(std::string("it is animated"));
  TexturePixels out =
      canvas(static_cast<std::size_t>(head.width), static_cast<std::size_t>(head.height));
  if (WebPDecodeRGBInto(bytes.data(), bytes.size(), out.rgb.data(), out.rgb.size(),
                        3 * head.width) == nullptr)
    return damaged("");
  return out;
}

}  // namespace onggi::textures

#include "kiosk/collection/textures/basis_lz.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "kiosk/collection/textures/bit_reader.h"

namespace onggi::textures {
namespace {

using Bytes = std::span<const std::uint8_t>;

tl::unexpected<std::string> unsound(const char* what) {
  return tl::unexpected(std::string("it is damaged: ") + what);
}

std::uint32_t whole(Bytes bytes, std::size_t at, int size) {
  BitReader reader(bytes.subspan(at));
  return reader.bits(8 * size);
}

/// A canonical Huffman code of up to 16 bits, as RFC 1951, section 3.2.2, numbers it.
class Huffman {
 public:
  static constexpr int kLongest = 16;

  /// Takes the code length of each symbol, 0: none. False if they form no valid code.
  bool make(const std::vector<std::uint8_t>& lengths) {
    count_.fill(0);
    for (const std::uint8_t length : lengths) ++count_[length];
    count_[0] = 0;
    std::array<std::uint32_t, kLongest + 2> first{};
    std::uint32_t used = 0;  // in codes of the longest kind
    for (std::size_t l = 1; l <= kLongest; ++l) {
      first[l + 1] = first[l] + count_[l];
      used += count_[l] << (kLongest - l);
    }
    if (used > 1u << kLongest) return false;
    symbols_.assign(first[kLongest + 1], 0);
    for (std::size_t s = 0; s < lengths.size(); ++s)
      if (lengths[s] > 0) symbols_[first[lengths[s]]++] = static_cast<std::uint16_t>(s);
    return true;
  }

  /// Reads the next symbol; sets `good` to false if the bits match none.
  std::uint32_t next(BitReader& in, bool& good) const {
    std::uint32_t code = 0, first = 0, index = 0;
    for (std::size_t l = 1; l <= kLongest; ++l) {
      code |= in.bit();
      if (code < first + count_[l]) return symbols_[index + code - first];
      index += count_[l];
      first = (first + count_[l]) << 1;
      code <<= 1;
    }
    good = false;
    return 0;
  }

 private:
  std::array<std::uint32_t, kLongest + 1> count_{};
  std::vector<std::uint16_t> symbols_;
};

/// "Compressed Huffman Tables".
bool read_table(BitReader& in, Huffman& out) {
  constexpr std::array<std::uint8_t, 21> kOrder{17, 18, 19, 20, 0,  8, 7,  9, 6,  10, 5,
                                                11, 4,  12, 3,  13, 2, 14, 1, 15, 16};
  const std::uint32_t symbols = in.bits(14);
  if (symbols == 0) return out.make({});
  const std::uint32_t codes = in.bits(5);
  if (codes == 0 || codes > kOrder.size()) return false;
  std::vector<std::uint8_t> lengths(kOrder.size(), 0);
  for (std::uint32_t i = 0; i < codes; ++i)
    lengths[kOrder[i]] = static_cast<std::uint8_t>(in.bits(3));
  Huffman lengths_code;
  if (!lengths_code.make(lengths)) return false;
  lengths.clear();
  bool good = true;
  while (good && lengths.size() < symbols) {
    const std::uint32_t symbol = lengths_code.next(in, good);
    if (symbol <= 16) {
      lengths.push_back(static_cast<std::uint8_t>(symbol));
      continue;
    }
    const bool zeros = symbol <= 18;
    if (!zeros && (lengths.empty() || lengths.back() == 0)) return false;
    const std::uint32_t times = symbol == 17   ? 3 + in.bits(3)
                                : symbol == 18 ? 11 + in.bits(7)
                                : symbol == 19 ? 3 + in.bits(2)
                                               : 7 + in.bits(7);
    lengths.insert(lengths.end(), times, zeros ? std::uint8_t{0} : lengths.back());
  }
  return good && !in.past() && lengths.size() == symbols && out.make(lengths);
}

struct Endpoint {
  std::array<std::uint8_t, 3> color{};  // 5 bits each
  std::uint8_t intensity = 0;
};
/// Sixteen values of 0 to 3, rows from the top, two bits each from the left.
using Selector = std::array<std::uint8_t, 4>;

/// Data that all levels of a picture share.
struct Codebooks {
  std::vector<Endpoint> endpoints;
  std::vector<Selector> selectors;
  Huffman predictions, deltas, selector_codes, run_codes;
  std::uint32_t history = 0;
};

bool read_endpoints(Bytes bytes, std::size_t count, Codebooks& out) {
  BitReader in(bytes);
  std::array<Huffman, 3> color;
  Huffman intensity;
  for (Huffman& table : color)
    if (!read_table(in, table)) return false;
  if (!read_table(in, intensity)) return false;
  const std::size_t channels = in.bit() != 0 ? 1 : 3;
  Endpoint last{{16, 16, 16}, 0};
  bool good = true;
  for (std::size_t i = 0; i < count && good; ++i) {
    last.intensity = static_cast<std::uint8_t>((last.intensity + intensity.next(in, good)) & 7);
    for (std::size_t k = 0; k < channels; ++k) {
      const std::uint8_t before = last.color[k];
      const Huffman& table = color[before <= 9 ? 0 : before <= 21 ? 1 : 2];
      last.color[k] = static_cast<std::uint8_t>((before + table.next(in, good)) & 31);
    }
    if (channels == 1) last.color[1] = last.color[2] = last.color[0];
    out.endpoints.push_back(last);
    good = good && !in.past();
  }
  return good;
}

bool read_selectors(Bytes bytes, std::size_t count, Codebooks& out) {
  BitReader in(bytes);
  if (in.bits(2) != 0) return false;
  const bool raw = in.bit() != 0;
  Huffman delta;
  if (!raw && !read_table(in, delta)) return false;
  bool good = true;
  for (std::size_t i = 0; i < count && good; ++i) {
    Selector selector;
    for (std::size_t j = 0; j < 4; ++j)
      selector[j] = static_cast<std::uint8_t>(
          raw || i == 0 ? in.bits(8) : out.selectors.back()[j] ^ delta.next(in, good));
    out.selectors.push_back(selector);
    good = good && !in.past();
  }
  return good;
}

bool read_tables(Bytes bytes, Codebooks& out) {
  BitReader in(bytes);
  for (Huffman* table : {&out.predictions, &out.deltas, &out.selector_codes, &out.run_codes})
    if (!read_table(in, *table)) return false;
  out.history = in.bits(13);
  return !in.past();
}

/// "ETC1S VLC Decoding Procedure": groups of `bits`, each with one more bit that announces another
/// group.
std::uint32_t variable(BitReader& in, int bits) {
  std::uint32_t out = 0;
  for (int at = 0; at < 32; at += bits) {
    out |= in.bits(bits) << at;
    if (in.bit() == 0) break;
  }
  return out;
}

/// "ETC1S Approximate Move to Front Routines".
class History {
 public:
  explicit History(std::size_t size) : values_(size, 0), next_(size / 2) {}
  void add(std::uint32_t value) {
    if (values_.empty()) return;
    values_[next_++] = value;
    if (next_ == values_.size()) next_ = values_.size() / 2;
  }
  std::uint32_t use(std::size_t index) {
    const std::uint32_t value = values_[index];
    std::swap(values_[index / 2], values_[index]);
    return value;
  }
  std::size_t size() const { return values_.size(); }

 private:
  std::vector<std::uint32_t> values_;
  std::size_t next_;
};

/// "ETC1S Slice Decoding": block by block an endpoint and a selector.
class Slice {
 public:
  Slice(const Codebooks& books, Bytes bytes, std::size_t across)
      : books_(books),
        in_(bytes),
        history_(books.history),
        above_(across, 0),
        pairs_(across / 2 + 1) {}

  /// The next block of a row, from the left.
  bool next(std::size_t x, std::size_t y, std::uint32_t& endpoint, std::uint32_t& selector) {
    if (x % 2 == 0) bits_ = y % 2 == 0 ? predictions(x) : pairs_[x / 2];
    const std::uint32_t way = bits_ & 3;
    bits_ >>= 2;
    if ((way == 0 && x == 0) || (way == 1 && y == 0) || (way == 2 && (x == 0 || y == 0)))
      return false;
    if (way == 1) last_ = above_[x];
    if (way == 2) last_ = above_left_;
    if (way == 3) {
      last_ += books_.deltas.next(in_, good_);
      if (last_ >= books_.endpoints.size())
        last_ -= static_cast<std::uint32_t>(books_.endpoints.size());
    }
    above_left_ = above_[x];
    above_[x] = last_;
    endpoint = last_;
    selector = next_selector();
    return good_ && !in_.past() && endpoint < books_.endpoints.size() &&
           selector < books_.selectors.size();
  }

 private:
  std::uint32_t predictions(std::size_t x) {
    constexpr std::uint32_t kAsBefore = 256, kLeastRun = 3;
    if (repeats_ > 0) {
      --repeats_;
    } else {
      const std::uint32_t symbol = books_.predictions.next(in_, good_);
      if (symbol == kAsBefore)
        repeats_ = variable(in_, 4) + kLeastRun - 1;
      else
        before_ = symbol;
    }
    pairs_[x / 2] = before_ >> 4;
    return before_;
  }

  std::uint32_t next_selector() {
    constexpr std::uint32_t kLongRun = 63, kLeastRun = 3;
    const auto count = static_cast<std::uint32_t>(books_.selectors.size());
    std::uint32_t symbol = count;
    if (run_ > 0) {
      --run_;
    } else {
      symbol = books_.selector_codes.next(in_, good_);
      if (symbol == count + books_.history) {
        const std::uint32_t length = books_.run_codes.next(in_, good_);
        run_ = (length == kLongRun ? variable(in_, 7) : length) + kLeastRun - 1;
        symbol = count;
      }
    }
    if (symbol < count) {
      history_.add(symbol);
      return symbol;
    }
    good_ = good_ && symbol - count < history_.size();
    return good_ ? history_.use(symbol - count) : 0;
  }

  const Codebooks& books_;
  BitReader in_;
  History history_;
  std::vector<std::uint32_t> above_, pairs_;
  std::uint32_t above_left_ = 0, bits_ = 0, before_ = 0, last_ = 0, repeats_ = 0, run_ = 0;
  bool good_ = true;
};

/// ETC1 (Khronos data format, section "ETC1"): what a texel's value adds to the base colour.
constexpr std::array<std::array<int, 4>, 8> kAdds{{{-8, -2, 2, 8},
                                                   {-17, -5, 5, 17},
                                                   {-29, -9, 9, 29},
                                                   {-42, -13, 13, 42},
                                                   {-60, -18, 18, 60},
                                                   {-80, -24, 24, 80},
                                                   {-106, -33, 33, 106},
                                                   {-183, -47, 47, 183}}};

void paint(const Endpoint& endpoint, const Selector& selector, int left, int top,
           TexturePixels& out) {
  for (int y = 0; y < 4 && top + y < out.height; ++y)
    for (int x = 0; x < 4 && left + x < out.width; ++x) {
      const std::size_t value = selector[static_cast<std::size_t>(y)] >> (2 * x) & 3;
      const std::size_t at =
          3 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(out.width) +
               static_cast<std::size_t>(left + x));
      for (std::size_t k = 0; k < 3; ++k) {
        const int base = endpoint.color[k] << 3 | endpoint.color[k] >> 2;
        out.rgb[at + k] =
            static_cast<std::uint8_t>(std::clamp(base + kAdds[endpoint.intensity][value], 0, 255));
      }
    }
}

}  // namespace

Decoded decode_basis_lz(Bytes global, std::size_t images, std::size_t image, Bytes level, int width,
                        int height) {
  constexpr std::size_t kHead = 20, kImage = 20;
  const std::size_t lists = kHead + kImage * images;
  if (global.size() < lists || image >= images) return unsound("its codebooks end too early");
  const std::size_t endpoints = whole(global, 0, 2), selectors = whole(global, 2, 2);
  std::array<Bytes, 3> sections;
  std::size_t at = lists;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t size = whole(global, 4 + 4 * i, 4);
    if (size > global.size() - at) return unsound("its codebooks end too early");
    sections[i] = global.subspan(at, size);
    at += size;
  }
  Codebooks books;
  if (!read_endpoints(sections[0], endpoints, books) ||
      !read_selectors(sections[1], selectors, books) || !read_tables(sections[2], books))
    return unsound("its codebooks");
  const std::size_t own = kHead + kImage * image;
  const std::size_t from = whole(global, own + 4, 4), size = whole(global, own + 8, 4);
  if (whole(global, own, 4) != 0) return tl::unexpected(std::string("it is an animation"));
  if (from > level.size() || size > level.size() - from)
    return unsound("its picture is larger than its level");

  TexturePixels out;
  out.width = width;
  out.height = height;
  const std::size_t across = static_cast<std::size_t>(width + 3) / 4,
                    down = static_cast<std::size_t>(height + 3) / 4;
  // Long runs cost no bits, so a few bytes can be a whole picture; its sides limit the memory.
  out.rgb.resize(std::size_t{3} * static_cast<std::size_t>(width) *
                 static_cast<std::size_t>(height));
  Slice slice(books, level.subspan(from, size), across);
  for (std::size_t y = 0; y < down; ++y)
    for (std::size_t x = 0; x < across; ++x) {
      std::uint32_t endpoint = 0, selector = 0;
      if (!slice.next(x, y, endpoint, selector)) return unsound("its blocks");
      paint(books.endpoints[endpoint], books.selectors[selector], 4 * static_cast<int>(x),
            4 * static_cast<int>(y), out);
    }
  return out;
}

}  // namespace onggi::textures

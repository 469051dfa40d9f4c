#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <unordered_map>

#include "kiosk/render/gl.h"
#include "kiosk/view/measure.h"

namespace onggi::render {

/// Sets paragraphs with Pango: any script, right to left included, lines broken by the language's
/// own habits, numbers in tabular figures. Measuring and drawing go through the same layout. Keeps
/// what it has set, the least used first out. Main thread.
class Typesetter final : public view::TextMeasure {
 public:
  Typesetter();
  ~Typesetter() override;

  Size measure(const std::string& text, const view::TextStyle& style, float width) const override;

  /// A paragraph as a coverage mask, ready to be drawn at (box.x - pad, box.y - pad).
  struct Block {
    Texture mask;
    int pad = 0;      ///< Pixels round the layout's box, for what overhangs it.
    float width = 0;  ///< Of the set text.
    float height = 0;
    std::size_t bytes = 0;
  };
  /// Valid until the next call.
  const Block& set(const std::string& text, const view::TextStyle& style, float width);

 private:
  struct Pango;
  std::unique_ptr<Pango> pango_;
  using Entry = std::pair<std::string, Block>;
  std::list<Entry> blocks_;  // most recently used first
  std::unordered_map<std::string, std::list<Entry>::iterator> index_;
  std::size_t bytes_ = 0;
  mutable std::unordered_map<std::string, Size> sizes_;
};

}  // namespace onggi::render

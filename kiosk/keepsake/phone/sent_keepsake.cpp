#include "kiosk/keepsake/phone/sent_keepsake.h"

#include <span>
#include <utility>

namespace onggi::phone {

web::SentFile sent(souvenir::KeepsakeFile opened) {
  web::SentFile file{std::move(opened.file), opened.size, std::move(opened.tag)};
  if (opened.stl)
    file.made = [stl = std::move(*opened.stl)](const files::Descriptor& of, std::uint64_t from,
                                               std::span<std::byte> into) {
      return stl.read(of, from, into);
    };
  return file;
}

}  // namespace onggi::phone

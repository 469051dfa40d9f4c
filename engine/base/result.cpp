#include "engine/base/result.h"

#include "engine/base/plain_text.h"

namespace onggi {

std::string to_text(const Problem& p) {
  using terminal::plain;
  return plain(p.where) + ": " + plain(p.what) + "\n  " + plain(p.remedy);
}

}  // namespace onggi

#include "engine/base/result.h"

namespace onggi {

std::string to_text(const Problem& p) { return p.where + ": " + p.what + "\n  " + p.remedy; }

}  // namespace onggi

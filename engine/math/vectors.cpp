#include "engine/math/vectors.h"

#include <hwy/highway.h>

#include <vector>

namespace onggi {
namespace {

// All that this machine has, whatever use_vectors() last said.
const std::vector<std::int64_t>& targets() {
  static const std::vector<std::int64_t> all = hwy::SupportedAndGeneratedTargets();
  return all;
}

}  // namespace

std::span<const std::string_view> vector_kinds() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (std::int64_t target : targets()) all.push_back(hwy::TargetName(target));
    return all;
  }();
  return names;
}

bool use_vectors(std::string_view kind) {
  std::int64_t chosen = 0;  // Highway's word for "whatever is best"
  for (std::int64_t target : targets())
    if (kind == hwy::TargetName(target)) chosen = target;
  if (chosen == 0 && !kind.empty()) return false;
  hwy::SetSupportedTargetsForTest(chosen);
  hwy::GetChosenTarget().DeInit();
  return true;
}

}  // namespace onggi

#include "kiosk/ground/web/message.h"

#include <algorithm>
#include <string_view>

namespace onggi::web {

BodyPlace Answering::place_for_body(const Ask&) { return IntoMemory{}; }

Answer Answering::refusal(int status, const Problem& why) {
  return {.status = status,
          .type = "text/plain; charset=utf-8",
          .body = why.what + ' ' + why.remedy + '\n'};
}

std::string asked_for(std::string_view target, std::string_view name) {
  const auto mark = std::min(target.find('?'), target.size());
  std::string_view query = target.substr(std::min(mark + 1, target.size()));
  while (!query.empty()) {
    const auto end = std::min(query.find('&'), query.size());
    const std::string_view one = query.substr(0, end);
    query.remove_prefix(std::min(end + 1, query.size()));
    if (one.size() > name.size() && one.starts_with(name) && one[name.size()] == '=')
      return std::string(one.substr(name.size() + 1));
  }
  return {};
}

Answer part_of(SentFile file, const std::string& type, const Ask& ask) {
  // A browser goes on where it stopped, but not into another file.
  const bool same = ask.if_range.empty() || ask.if_range == '"' + file.tag + '"';
  const ByteRange range = byte_range(same ? ask.range : "", file.size);
  Answer answer{.status = 200, .type = type};
  if (range.kind == ByteRange::Kind::span) answer.status = 206;
  if (range.kind == ByteRange::Kind::beyond) answer = {.status = 416, .type = ""};
  answer.span = range.span;
  answer.file = std::move(file);
  return answer;
}

}  // namespace onggi::web

#include "kiosk/program/console/change_words.h"

#include "kiosk/ground/files/json.h"
#include "kiosk/program/console/said.h"

namespace onggi::console {

web::Answer answer_of(const std::vector<ChangeFault>& faults, int status) {
  using files::Json;
  Json list = Json::list();
  for (const ChangeFault& fault : faults)
    list.push_back(
        Json::object({{"key", fault.key}, {"what", fault.what}, {"remedy", fault.remedy}}));
  web::Answer answer = json(Json::object({{"faults", list}}));
  answer.status = status;
  return answer;
}

ChangeWords words_of(const changes::Draft& draft) {
  ChangeWords words;
  for (const changes::ChangedValue& value : draft.values)
    if (value.is.empty())
      words.without += (words.without.empty() ? "" : ",") + value.key;
    else
      words.pairs.insert(words.pairs.end(), {value.key, value.is});
  return words;
}

}  // namespace onggi::console

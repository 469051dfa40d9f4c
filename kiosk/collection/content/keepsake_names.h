#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::content {

/// The names that visitors remember their keepsakes by: three words, "quiet blue heron". Each word
/// stands for the same in every language, so a name that was said in one is found in another.
class KeepsakeNames {
 public:
  struct Read;
  /// Reads content/names.toml. One of `languages` without an order is noted; with one it needs each
  /// word. A word without English is left out.
  static Read read(const std::filesystem::path& file,
                   const std::vector<std::string>& languages = {});

  /// True if there are words for a name.
  bool any() const;
  /// The id of a name that is not in `taken`, "quiet-blue-heron"; the same for the same `seed`. ""
  /// if all are taken.
  std::string pick(std::uint64_t seed, const std::set<std::string>& taken) const;
  /// The name in `language`, else in English. An id with a word that the file no longer has is said
  /// as it is written.
  std::string said(const std::string& id, const std::string& language) const;
  /// True if `typed` is in the name of `id` in any language: a word of it is enough. Case, accents,
  /// spaces and signs do not count.
  bool matches(const std::string& id, const std::string& typed) const;
  /// True if `typed` is all of the name `id`, in any language, in whatever case.
  bool is_called(const std::string& id, const std::string& typed) const;
  const std::vector<std::string>& languages() const { return languages_; }

 private:
  struct Word {
    std::string id;
    std::map<std::string, std::string> in;  ///< As written, by language.
  };
  static constexpr std::array<const char*, 3> kLists{"first", "second", "thing"};

  std::array<std::vector<Word>, 3> words_;
  std::map<std::string, std::string> order_;  ///< By language.
  std::vector<std::string> languages_;        ///< Those of order_.
};

struct KeepsakeNames::Read {
  KeepsakeNames names;
  std::vector<Problem> problems;
  std::vector<Problem> notes;  ///< Languages without names.
  int keys_checked = 0;
};

/// The file of names of the exhibit `file`: content/names.toml of its own site, else of the
/// program.
std::filesystem::path names_file(const std::filesystem::path& exhibit);

}  // namespace onggi::content

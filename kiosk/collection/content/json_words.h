#pragma once

#include <initializer_list>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace onggi::content::json_words {

/// Reads texts from JSON that others wrote: JSON-LD, XMP, IIIF, Smithsonian documents. But for
/// string_in() the result is always a clean text: at most 1000 bytes, whole characters, no control
/// characters; "" if there is none. Allocates.

std::string lower(std::string text);
/// One line without control characters, cut between two characters of UTF-8.
std::string tidy(std::string text);
/// The member of `object`, or nullptr; nullptr for anything that is not an object.
const nlohmann::json* member(const nlohmann::json& object, std::string_view key);
/// The same as a value: null JSON if there is none.
const nlohmann::json& within(const nlohmann::json& object, std::string_view key);
/// The list `key` of `object`; empty if there is none.
const nlohmann::json& list_of(const nlohmann::json& object, std::string_view key);
/// The index `key` of `object`, 0 to 2^30 - 1; else `otherwise`.
int index_in(const nlohmann::json& object, std::string_view key, int otherwise = -1);
/// The text `key` of `object` as it is; "" if it is none.
std::string string_in(const nlohmann::json& object, std::string_view key);
/// A value as words: a string, a list of them, one in a language (JSON-LD's "@language", IIIF's
/// {"en": [...]}), or a name inside an object. English goes before other languages.
std::string words_of(const nlohmann::json& value, int depth = 0);
/// The text of the first of `keys` (in lower case) that `object` has.
std::string first_of(const nlohmann::json& object, std::initializer_list<const char*> keys);
/// The first of `keys` that holds a page which a phone can open (content/address.h).
std::string page_of(const nlohmann::json& object, std::initializer_list<const char*> keys);
/// IIIF's and Voyager's texts by language: {"en": ["Jar"], "ko": "항아리"}; keys in lower case, at
/// most 12 and those of two or three letters alone.
std::map<std::string, std::string> by_language(const nlohmann::json& value);

}  // namespace onggi::content::json_words

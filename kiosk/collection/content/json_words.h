#pragma once

#include <initializer_list>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace onggi::content::json_words {

/// Words out of what others wrote as JSON: JSON-LD, XMP, IIIF, Smithsonian documents. Whatever
/// stands there, a text comes out: at most 1000 bytes, whole characters, no control characters; ""
/// where there are no words. Allocates.

std::string lower(std::string text);
/// One line without control characters, cut between two characters of UTF-8.
std::string tidy(std::string text);
/// `object`'s member, or nullptr; so for anything that is no object.
const nlohmann::json* member(const nlohmann::json& object, const std::string& key);
/// A value as words: a string, a list of them, one in a language (JSON-LD's "@language", IIIF's
/// {"en": [...]}), or a name inside an object. English goes before other languages.
std::string words_of(const nlohmann::json& value, int depth = 0);
/// The words of the first of `keys` (in lower case) that `object` has.
std::string first_of(const nlohmann::json& object, std::initializer_list<const char*> keys);
/// The first of `keys` that holds a page which a phone opens (content/address.h).
std::string page_of(const nlohmann::json& object, std::initializer_list<const char*> keys);
/// IIIF's and Voyager's texts by language: {"en": ["Jar"], "ko": "항아리"}; keys in lower case, at
/// most 12 and those of two or three letters alone.
std::map<std::string, std::string> by_language(const nlohmann::json& value);

}  // namespace onggi::content::json_words

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "kiosk/ground/fields/field.h"

namespace onggi::fields::test {

using Lines = std::vector<std::string>;

inline Lines lines_of(const std::filesystem::path& file) {
  Lines lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// With ONGGI_WRITE=1 a page or file that differs from the list is written anew.
inline bool writes() { return std::getenv("ONGGI_WRITE") != nullptr; }

inline void write(const std::filesystem::path& file, const Lines& lines) {
  std::ofstream out(file);
  for (const std::string& line : lines) out << line << '\n';
}

constexpr const char* kWrite =
    "Run this test with ONGGI_WRITE=1 in the source's folder, and it writes the file.";

/// The names of the list's tables that the page shows, in its order, each once.
inline std::vector<std::string> tables_of(const FieldList& list) {
  std::vector<std::string> names;
  for (const Field& field : list.fields)
    if (field.on_page && std::find(names.begin(), names.end(), field.table) == names.end())
      names.push_back(field.table);
  return names;
}

/// Expects, below the heading of each table of `list` behind the line `chapter` of
/// config/README.md, the list's rows and no others. `before`: a line that stands before the table
/// of a name.
inline void expect_on_page(const FieldList& list, const std::string& chapter,
                           const std::function<std::string(const std::string&)>& before) {
  const std::filesystem::path page = "config/README.md";
  const Lines read = lines_of(page);
  Lines lines = read;
  for (const std::string& name : tables_of(list)) {
    const auto from = std::find(lines.begin(), lines.end(), chapter);
    ASSERT_NE(from, lines.end()) << chapter;
    const auto at = std::find_if(from, lines.end(),
                                 [&](const std::string& l) { return l.starts_with(before(name)); });
    ASSERT_NE(at, lines.end()) << "Write a line into " << page << ": " << before(name);
    const auto begin =
        std::find_if(at, lines.end(), [](const std::string& l) { return l.starts_with("| "); });
    const auto end =
        std::find_if(begin, lines.end(), [](const std::string& l) { return !l.starts_with("|"); });
    Lines table{"| key | meaning | unit, range | default |", "|---|---|---|---|"};
    for (const Field& field : list.fields)
      if (field.table == name && field.on_page) table.push_back(page_row(field));
    EXPECT_TRUE(writes() || Lines(begin, end) == table)
        << "The table below " << before(name) << " differs from the list. " << kWrite;
    lines.insert(lines.erase(begin, end), table.begin(), table.end());
  }
  if (writes() && lines != read) write(page, lines);
}

/// Expects each key once, with words of one line.
inline void expect_whole(const FieldList& list) {
  std::vector<std::string> names;
  for (const Field& field : list.fields) {
    EXPECT_EQ(std::count(names.begin(), names.end(), field.name()), 0) << field.name();
    names.push_back(field.name());
    EXPECT_FALSE(field.words.empty()) << field.name() << " has no words.";
    EXPECT_EQ(field.words.find_first_of("|\n"), std::string::npos) << field.name();
  }
}

}  // namespace onggi::fields::test

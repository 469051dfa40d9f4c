#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace onggi::settings {

/// Reads one TOML file table by table and remembers what was wrong where: wrong keys (with the
/// nearest right one), types, ranges, missing keys. The only way into TOML for every room: toml++
/// stays behind it. Allocates; main thread.
class TomlReader {
 public:
  /// Parses; a syntax error or unreadable file becomes the only Problem and ok() is false.
  /// Files over 4 MiB and anything but regular files are refused.
  explicit TomlReader(const std::filesystem::path& file);
  ~TomlReader();
  TomlReader(TomlReader&&) noexcept;

  bool ok() const;
  /// One table of the file ("" is the root; "a.b" nests). Valid while the reader lives.
  class Table {
   public:
    bool present() const;
    /// Each reads `key` into `out` if it is there and good; notes a Problem if not good. True if
    /// read.
    bool number(std::string_view key, double& out, double low, double high);
    bool integer(std::string_view key, int& out, int low, int high);
    bool boolean(std::string_view key, bool& out);
    bool text(std::string_view key, std::string& out);
    bool texts(std::string_view key, std::vector<std::string>& out);
    bool numbers(std::string_view key, std::vector<double>& out);
    /// An array of [a, b] pairs of numbers.
    bool pairs(std::string_view key, std::vector<std::pair<double, double>>& out);
    /// Notes a Problem at `key` (or at the table) in the file's words.
    void complain(std::string_view key, std::string what, std::string remedy);
    /// Notes a Problem when `key` is absent.
    void require(std::string_view key, std::string remedy);
    /// Every key present, in file order.
    std::vector<std::string> keys() const;
    Table child(std::string_view name);
    /// Notes a Problem for every key that nobody asked for, naming the nearest that was asked for.
    void finish();

   private:
    friend class TomlReader;
    struct Impl;
    std::shared_ptr<Impl> impl_;
  };
  Table root();

  const std::vector<Problem>& problems() const;
  int keys_checked() const;

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
};

/// The name in `names` nearest to `word` by edit distance, if within a third of its length; else
/// "".
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

}  // namespace onggi::settings

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"

namespace onggi::toml {

/// A point of a drawn outline, in the drawing's own unit: `[radius, height]`, or
/// `[radius, height, "corner"]` where the line turns sharply.
struct OutlinePoint {
  double radius = 0.0;
  double height = 0.0;
  bool corner = false;
  friend bool operator==(const OutlinePoint&, const OutlinePoint&) = default;
};

/// Reads one TOML file table by table and remembers what was wrong where: wrong keys (with the
/// nearest right one), types, ranges, missing keys. The only way into TOML for every room: toml++
/// stays behind it. Allocates; one thread at a time.
class TomlReader {
 public:
  /// Parses; a syntax error or unreadable file becomes the only Problem and ok() is false.
  /// Files over 4 MiB and anything but regular files are refused.
  explicit TomlReader(const std::filesystem::path& file);
  /// The same of a text in memory; `name` is what its Problems call it.
  static TomlReader of_text(const std::string& text, const std::string& name);
  ~TomlReader();
  TomlReader(TomlReader&&) noexcept;

  bool ok() const;
  /// One table of the file. Valid while the reader lives. An absent one reads nothing and notes
  /// nothing but what require() and complain() are asked to.
  class Table {
   public:
    bool present() const;
    /// Is `key` written in this table, whatever its type?
    bool has(std::string_view key) const;
    /// Is `key` written in this table as a table of its own ([key], or key.other = ...)?
    bool has_table(std::string_view key) const;
    /// Each reads `key` into `out` if it is there and good; notes a Problem if not good (and leaves
    /// `out` alone). True if read.
    /// `low` and `high` are included; `unit` is for the Problem's words ("s", "metres"). A whole
    /// number is a number; nan and inf are not.
    bool number(std::string_view key, double& out, double low, double high,
                std::string_view unit = {});
    bool integer(std::string_view key, int& out, int low, int high, std::string_view unit = {});
    bool boolean(std::string_view key, bool& out);
    bool text(std::string_view key, std::string& out);
    bool texts(std::string_view key, std::vector<std::string>& out);
    bool numbers(std::string_view key, std::vector<double>& out);
    /// An array of [a, b] pairs of numbers.
    bool pairs(std::string_view key, std::vector<std::pair<double, double>>& out);
    /// An array of [radius, height] or [radius, height, "corner"].
    bool points(std::string_view key, std::vector<OutlinePoint>& out);
    /// Notes a Problem at `key`'s value (or at the table, where `key` is absent or ""). `what` and
    /// `remedy` are whole sentences and are kept as they are.
    void complain(std::string_view key, std::string what, std::string remedy);
    /// The same at element `index` of the list `key`.
    void complain_at(std::string_view key, std::size_t index, std::string what, std::string remedy);
    /// Notes a Problem when `key` is absent.
    void require(std::string_view key, std::string remedy);
    /// Every key present, in file order.
    std::vector<std::string> keys() const;
    /// The table [name] below this one.
    Table child(std::string_view name);
    /// Every [[name]] below this one, in file order; none where absent.
    std::vector<Table> children(std::string_view name);
    /// Notes a Problem for every key that nobody asked for, naming the nearest that was asked for.
    /// Call it when all keys have been asked for.
    void finish();

   private:
    friend class TomlReader;
    struct Impl;
    std::shared_ptr<Impl> impl_;
  };
  Table root();

  /// In file order. Every `where` is "file:line:column", or "file" where it could not be read.
  const std::vector<Problem>& problems() const;
  /// Those that problems() did not have yet when it was `before`.
  std::vector<Problem> problems_since(const std::vector<Problem>& before) const;
  /// Keys that are present and were asked for, tables not counted.
  int keys_checked() const;

 private:
  struct Impl;
  TomlReader();
  void parse(const std::string& text);
  std::shared_ptr<Impl> impl_;
};

}  // namespace onggi::toml

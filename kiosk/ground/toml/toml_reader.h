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

/// Reads one TOML file table by table and notes wrong keys (with the nearest right one), types,
/// ranges and missing keys, with their place. Every room reads TOML through this class, which hides
/// toml++. Allocates; one thread at a time.
class TomlReader {
 public:
  /// Parses; a syntax error or unreadable file becomes the only Problem and ok() is false.
  /// Files over 4 MiB and anything but regular files are refused.
  explicit TomlReader(const std::filesystem::path& file);
  /// The same for a text in memory; its Problems call it `name`.
  static TomlReader of_text(const std::string& text, const std::string& name);
  ~TomlReader();
  TomlReader(TomlReader&&) noexcept;

  bool ok() const;
  /// One table of the file. Valid while the reader lives. An absent table reads nothing and notes
  /// only what require() and complain() ask for.
  class Table {
   public:
    bool present() const;
    /// True if this table has `key`, of any type.
    bool has(std::string_view key) const;
    /// True if this table has `key` as a table ([key], or key.other = ...).
    bool has_table(std::string_view key) const;
    /// Each function reads `key` into `out` and returns true if the key is present and valid. If it
    /// is invalid, it notes a Problem and leaves `out` alone. `low` and `high` are included; `unit`
    /// is for the Problem's text ("s", "metres"). A whole number is a number; nan and inf are not.
    bool number(std::string_view key, double& out, double low, double high,
                std::string_view unit = {});
    bool integer(std::string_view key, int& out, int low, int high, std::string_view unit = {});
    bool boolean(std::string_view key, bool& out);
    bool text(std::string_view key, std::string& out);
    bool texts(std::string_view key, std::vector<std::string>& out);
    bool numbers(std::string_view key, std::vector<double>& out);
    /// An array of [radius, height] or [radius, height, "corner"]; a Problem calls the two `axes`.
    bool points(std::string_view key, std::vector<OutlinePoint>& out,
                std::string_view axes = "radius, height");
    /// Notes a Problem at `key`'s value, or at the table if `key` is absent or "". `what` and
    /// `remedy` are whole sentences and are used unchanged.
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
    /// Notes a Problem for every key that the program did not ask for, with the nearest known key.
    /// Call it after all keys were asked for.
    void finish();

   private:
    friend class TomlReader;
    struct Impl;
    std::shared_ptr<Impl> impl_;
  };
  Table root();

  /// In file order. Every `where` is "file:line:column", or "file" where it could not be read.
  const std::vector<Problem>& problems() const;
  /// The Problems that are not in `before`, an earlier copy of problems().
  std::vector<Problem> problems_since(const std::vector<Problem>& before) const;
  /// Number of keys that are present and were asked for, without tables.
  int keys_checked() const;

 private:
  struct Impl;
  TomlReader();
  void parse(const std::string& text);
  std::shared_ptr<Impl> impl_;
};

}  // namespace onggi::toml

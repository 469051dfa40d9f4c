#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/kiosk/program/commands/temporary_exhibit.h"

namespace onggi::commands {

/// What a run of the real program came to.
struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

/// Runs `onggi ARGUMENTS` through the shell, with no display of anyone's, after the shell's
/// `first`.
inline Outcome onggi(const std::string& arguments, const std::string& first = "true") {
  const ScratchFolder folder;
  const std::string out = (folder / "out").string(), err = (folder / "err").string();
  const std::string command = first + " && unset DISPLAY WAYLAND_DISPLAY && '" ONGGI_PROGRAM "' " +
                              arguments + " >'" + out + "' 2>'" + err + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, content(out), content(err)};
}

}  // namespace onggi::commands

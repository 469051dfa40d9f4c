# The kiosk's libraries, and what is asked of their versions: here and nowhere else. The versions are those
# of Debian 12 where the kiosk is known to need what came with them, and Debian 13 has newer ones.
# Each is linked by the rooms that its line names.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
find_package(Threads REQUIRED)

onggi_library(tomlplusplus  AT_LEAST 3.3  DEBIAN libtomlplusplus-dev)     # toml
onggi_library(TinyGLTF      AT_LEAST 2.7  DEBIAN libtinygltf-dev)         # content
onggi_library(meshoptimizer AT_LEAST 0.18 DEBIAN libmeshoptimizer-dev)    # content
onggi_library(draco         OPTIONAL)  # content: without it Draco meshes are refused by name
onggi_library(assimp        OPTIONAL)  # content's helper: without it OBJ, PLY and STL are refused by name
onggi_library(LIBZIP        MODULES libzip AT_LEAST 1.7 DEBIAN libzip-dev)  # archives
onggi_library(PNG           DEBIAN libpng-dev)                            # textures
onggi_library(JPEG          DEBIAN libjpeg-dev)                           # textures
onggi_library(WEBP          MODULES libwebp DEBIAN libwebp-dev)           # textures
onggi_library(ZSTD          MODULES libzstd DEBIAN libzstd-dev)           # files, textures
onggi_library(nlohmann_json AT_LEAST 3.11 DEBIAN nlohmann-json3-dev)      # files, content, souvenir, encoding's helper, console
onggi_library(HIDAPI        MODULES hidapi-hidraw AT_LEAST 0.13 DEBIAN libhidapi-dev)  # device
onggi_library(QRCODEGEN     MODULES qrcodegencpp DEBIAN libqrcodegencpp-dev)  # view
onggi_library(glfw3         AT_LEAST 3.3  DEBIAN libglfw3-dev)            # render
onggi_library(glm           DEBIAN libglm-dev)                            # render
onggi_library(EPOXY         MODULES epoxy AT_LEAST 1.5 DEBIAN libepoxy-dev)  # render
onggi_library(XINPUT        MODULES x11 xi xrandr xext DEBIAN "libxi-dev libxrandr-dev libxext-dev")  # render: touch, monitors
onggi_library(PANGOCAIRO    MODULES pangocairo AT_LEAST 1.50 DEBIAN libpango1.0-dev)  # render, drawing
onggi_library(FONTCONFIG    MODULES fontconfig DEBIAN libfontconfig-dev)  # render: which letters have a font
onggi_library(OPENIMAGEIO   MODULES OpenImageIO AT_LEAST 2.4 DEBIAN libopenimageio-dev)  # encoding's helper
onggi_library(GIF           AT_LEAST 5.1  DEBIAN libgif-dev)              # encoding
onggi_library(Boost         AT_LEAST 1.74 DEBIAN libboost-dev)            # web: Beast
onggi_library(SQLite3       AT_LEAST 3.40 DEBIAN libsqlite3-dev)          # store
onggi_library(SODIUM        MODULES libsodium DEBIAN libsodium-dev)       # console: passphrases
onggi_library(SPEECHD       MODULES speech-dispatcher AT_LEAST 0.11 DEBIAN libspeechd-dev)  # access's helper
onggi_library(SDL2          MODULES sdl2 AT_LEAST 2.26 DEBIAN libsdl2-dev)  # sound
onggi_library(ALSA          MODULES alsa DEBIAN libasound2-dev)           # sound
onggi_library(SYSTEMD       MODULES libsystemd AT_LEAST 252 DEBIAN libsystemd-dev)  # watch
onggi_library(spdlog        AT_LEAST 1.10 DEBIAN libspdlog-dev)           # files
onggi_library(CLI11         AT_LEAST 2.1  DEBIAN libcli11-dev)            # cli
onggi_header(ONGGI_READERWRITERQUEUE readerwriterqueue/readerwriterqueue.h DEBIAN libreaderwriterqueue-dev)  # loop
if(NOT ONGGI_TESTS)
  onggi_libraries_found("bash kiosk/install-packages kiosk/packages.txt")
endif()

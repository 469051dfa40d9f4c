#include "kiosk/ground/secrets/digest.h"

#include <sodium.h>

#include <array>

namespace onggi::secrets {

std::string digest_of(std::string_view secret) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> bytes{};
  ::crypto_hash_sha256(bytes.data(), reinterpret_cast<const unsigned char*>(secret.data()),
                       secret.size());
  std::array<char, 2 * crypto_hash_sha256_BYTES + 1> text{};
  return ::sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
}

bool same_secret(std::string_view a, std::string_view b) {
  return a.size() == b.size() && ::sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace onggi::secrets

#include "reports/document/packed.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

namespace plumb::reports {

void Packed::add_whole(std::uint32_t x, int bytes) {
  for (int i = 0; i < bytes; ++i) bytes_ += static_cast<char>(static_cast<unsigned char>((x >> (8 * i)) & 0xFFU));
}

void Packed::add_float(double x) {
  add_whole(std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(x, -1e30, 1e30))), 4);
}

void Packed::add_part(double x) {
  const auto whole = static_cast<std::int32_t>(std::lround(32767 * std::clamp(x, -1.0, 1.0)));
  add_whole(static_cast<std::uint32_t>(whole), 2);
}

std::string Packed::text() const {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) {
    return i < bytes_.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[i])) : 0U;
  };
  std::string out;
  out.reserve((bytes_.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes_.size(); i += 3) {
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (int shift = 18; shift >= 0; shift -= 6) out += digits[(three >> shift) & 63U];
  }
  for (std::size_t i = 0; i < (3 - bytes_.size() % 3) % 3; ++i) out[out.size() - 1 - i] = '=';
  return out;
}

}  // namespace plumb::reports

// Many numbers in little room: what decimals take three times as long to say.
#pragma once

#include <cstdint>
#include <string>

namespace plumb::reports {

/// The numbers' bytes, of each the least first, as base64.
class Packed {
 public:
  /// As a float; what is beyond +-1e30 stays there.
  void add_float(double x);
  /// A part of one, from -1 to 1, as a whole number of 1/32767.
  void add_part(double x);
  void add_whole(std::uint32_t x, int bytes);
  [[nodiscard]] std::string text() const;

 private:
  std::string bytes_;
};

}  // namespace plumb::reports

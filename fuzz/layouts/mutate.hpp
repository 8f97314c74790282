// How one input becomes another: by what its bytes mean. An engine that flips bits needs luck to bring two axes into line; here
// it is one step. Total: whatever the bytes, the result has the layout's size.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "properties/generators/stream.hpp"

namespace plumb {

enum class FieldKind : std::uint8_t {
  choice,     ///< each value is another kind of thing
  scale,      ///< special values below 256, a log scale above
  magnitude,  ///< a log scale that begins at 1e-16
  angle,      ///< v % 4: 0 round, 1 nearly round, 2 and 3 any
  number      ///< more is more
};

struct ByteField {
  std::uint8_t offset, width;
  FieldKind kind;
};

/// Bytes that make a place where solvers break, whatever the others are: "coaxial", "touching".
struct Stroke {
  struct Byte {
    std::uint8_t offset, value;
  };
  std::string_view name;
  std::vector<Byte> bytes;
};

struct Layout {
  std::string_view name;
  std::size_t size;
  std::vector<ByteField> fields;
  std::vector<Stroke> strokes;
  std::size_t body_size = 0;  ///< bodies stand at 0 and at body_size
};

[[nodiscard]] const Layout& pair_layout();     ///< pair-1, decode.hpp
[[nodiscard]] const Layout& path_layout();     ///< path-1, decode_path.hpp
[[nodiscard]] const Layout& contact_layout();  ///< contact-1, decode_contact.hpp
[[nodiscard]] const Layout& shapes_layout();   ///< shapes-1, decode_shapes.hpp

/// One to four steps: a field scaled, snapped to a special value, moved by one, drawn anew; a stroke; the bodies exchanged, one
/// copied, wholly or in its shape or its pose.
void mutate(const Layout& layout, std::vector<std::uint8_t>& bytes, Stream& stream);

/// ByteField by field of one or the other, or body 1 of one and body 2 of the other, or the shapes of one in the pose of the other.
[[nodiscard]] std::vector<std::uint8_t> cross(const Layout& layout, std::span<const std::uint8_t> a,
                                              std::span<const std::uint8_t> b, Stream& stream);

}  // namespace plumb

#include "fuzz/layouts/mutate.hpp"

#include <algorithm>
#include <array>

#include "fuzz/layouts/layout_fields.hpp"

namespace plumb {
namespace {

using Buffer = std::vector<std::uint8_t>;

void write(Buffer& bytes, const ByteField& field, std::uint32_t value) {
  for (std::size_t i = 0; i < field.width; ++i) bytes[field.offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

std::uint32_t greatest(const ByteField& field) {
  return field.width == 4 ? 0xffffffffu : (1u << (8 * field.width)) - 1;
}

/// Up or down by a power of two, from one unit in the last place to half the range; stops at the ends.
std::uint32_t stepped(const ByteField& field, std::uint32_t value, Stream& stream) {
  const std::int64_t step = std::int64_t{1} << stream.below(8 * std::size_t{field.width});
  const std::int64_t moved = stream.chance(0.5) ? value + step : value - step;
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(moved, 0, greatest(field)));
}

std::uint32_t drawn(const ByteField& field, Stream& stream) {
  return static_cast<std::uint32_t>(stream.bits()) & greatest(field);
}

/// A round angle, or one that misses it by 10^(-16 .. 0) rad.
std::uint32_t special_angle(Stream& stream) {
  const auto round = static_cast<std::uint32_t>(stream.below(24)) << 2;
  if (stream.chance(0.5)) return round;
  const auto miss = static_cast<std::uint32_t>(stream.bits());
  return round | 1u | (miss & 0xffff8000u);
}

std::uint32_t snapped(const ByteField& field, Stream& stream) {
  switch (field.kind) {
    case FieldKind::angle: return special_angle(stream);
    case FieldKind::number: return stream.chance(0.5) ? 0 : greatest(field);
    default: return static_cast<std::uint32_t>(stream.below(256));
  }
}

void change_field(const Layout& layout, Buffer& bytes, Stream& stream) {
  const ByteField& field = layout.fields[stream.below(layout.fields.size())];
  const std::uint32_t value = layout::read(bytes, field.offset, field.width);
  if (field.kind == FieldKind::choice) return write(bytes, field, drawn(field, stream));
  switch (stream.below(4)) {
    case 0: return write(bytes, field, drawn(field, stream));
    case 1: return write(bytes, field, snapped(field, stream));
    default: return write(bytes, field, stepped(field, value, stream));
  }
}

void stroke(const Layout& layout, Buffer& bytes, Stream& stream) {
  for (const auto& [offset, value] : layout.strokes[stream.below(layout.strokes.size())].bytes) bytes[offset] = value;
}

/// The part of a body's block that is its shape: class at 0, aspects, exponents and size at 2..11, what a longer block has after its pose.
bool is_shape(std::size_t offset) {
  return offset == 0 || (offset >= 2 && offset < 12) || offset >= layout::kBodySize;
}

enum class Part : std::uint8_t { all, shape, pose };

bool is_of(Part part, std::size_t offset) {
  return part == Part::all || is_shape(offset) == (part == Part::shape);
}

void copy_body(const Layout& layout, Buffer& bytes, Stream& stream) {
  constexpr std::array parts{Part::all, Part::shape, Part::pose};
  const Part part = stream.pick(parts);
  const bool forth = stream.chance(0.5);
  for (std::size_t i = 0; i < layout.body_size; ++i)
    if (is_of(part, i)) bytes[i + (forth ? layout.body_size : 0)] = bytes[i + (forth ? 0 : layout.body_size)];
}

void exchange_bodies(const Layout& layout, Buffer& bytes) {
  const auto middle = bytes.begin() + static_cast<std::ptrdiff_t>(layout.body_size);
  std::swap_ranges(bytes.begin(), middle, middle);
}

void step(const Layout& layout, Buffer& bytes, Stream& stream) {
  switch (stream.below(8)) {
    case 0: return stroke(layout, bytes, stream);
    case 1: return copy_body(layout, bytes, stream);
    case 2: return exchange_bodies(layout, bytes);
    default: return change_field(layout, bytes, stream);
  }
}

}  // namespace

void mutate(const Layout& layout, Buffer& bytes, Stream& stream) {
  bytes.resize(layout.size);
  const std::size_t steps = std::size_t{1} << stream.below(3);
  for (std::size_t i = 0; i < steps; ++i) step(layout, bytes, stream);
}

Buffer cross(const Layout& layout, std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, Stream& stream) {
  Buffer out(a.begin(), a.end()), other(b.begin(), b.end());
  out.resize(layout.size);
  other.resize(layout.size);
  const std::size_t way = stream.below(3);
  for (const ByteField& field : layout.fields) {
    const bool in_body = field.offset < 2 * layout.body_size, of_second = field.offset >= layout.body_size;
    const bool taken = way == 0   ? stream.chance(0.5)
                       : way == 1 ? in_body && of_second
                                  : in_body && is_shape(field.offset % layout.body_size);
    if (taken) write(out, field, layout::read(other, field.offset, field.width));
  }
  return out;
}

}  // namespace plumb

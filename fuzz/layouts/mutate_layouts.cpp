// The layouts as the mutator sees them; decode.hpp, decode_contact.hpp, decode_path.hpp and decode_shapes.hpp say what each byte
// means.
#include "fuzz/layouts/decode.hpp"
#include "fuzz/layouts/decode_contact.hpp"
#include "fuzz/layouts/decode_path.hpp"
#include "fuzz/layouts/decode_shapes.hpp"
#include "fuzz/layouts/layout_fields.hpp"
#include "fuzz/layouts/mutate.hpp"

namespace plumb {
namespace {

using layout::kBodySize;

void add_twice(std::vector<ByteField>& fields, std::initializer_list<ByteField> body) {
  for (const std::size_t at : {std::size_t{0}, kBodySize})
    for (const ByteField& field : body)
      fields.push_back({static_cast<std::uint8_t>(at + field.offset), field.width, field.kind});
}

constexpr std::initializer_list<ByteField> kShape{{0, 1, FieldKind::choice}, {2, 2, FieldKind::scale},
                                                  {4, 2, FieldKind::scale},  {6, 2, FieldKind::scale},
                                                  {8, 2, FieldKind::scale},  {10, 2, FieldKind::scale}};

std::vector<ByteField> pair_fields() {
  std::vector<ByteField> fields{{56, 4, FieldKind::angle},     {60, 4, FieldKind::angle},  {64, 1, FieldKind::choice},
                                {66, 2, FieldKind::magnitude}, {68, 1, FieldKind::choice}, {69, 1, FieldKind::number},
                                {70, 1, FieldKind::choice},    {71, 1, FieldKind::number}};
  add_twice(fields, kShape);
  add_twice(fields, {{1, 1, FieldKind::choice},
                     {12, 4, FieldKind::angle},
                     {16, 4, FieldKind::angle},
                     {20, 4, FieldKind::angle},
                     {24, 4, FieldKind::number}});
  return fields;
}

std::vector<ByteField> path_fields() {
  std::vector<ByteField> fields = pair_fields();
  fields.insert(fields.end(), {{72, 1, FieldKind::choice},
                               {73, 1, FieldKind::number},
                               {74, 1, FieldKind::choice},
                               {75, 1, FieldKind::number},
                               {76, 2, FieldKind::scale},
                               {78, 1, FieldKind::choice},
                               {79, 1, FieldKind::choice},
                               {80, 4, FieldKind::angle},
                               {84, 4, FieldKind::angle}});
  return fields;
}

std::vector<ByteField> contact_fields() {
  std::vector<ByteField> fields{{56, 4, FieldKind::angle},  {60, 1, FieldKind::choice}, {62, 2, FieldKind::magnitude},
                                {64, 1, FieldKind::choice}, {65, 1, FieldKind::number}, {66, 1, FieldKind::choice},
                                {67, 1, FieldKind::number}, {68, 4, FieldKind::angle},  {72, 4, FieldKind::angle},
                                {76, 4, FieldKind::angle}};
  add_twice(fields, kShape);
  add_twice(fields, {{1, 1, FieldKind::choice},
                     {12, 2, FieldKind::magnitude},
                     {14, 1, FieldKind::choice},
                     {16, 4, FieldKind::angle}});
  return fields;
}

/// `count` zeros from an offset on.
std::vector<Stroke::Byte> zeros(int offset, int count) {
  std::vector<Stroke::Byte> out;
  for (int i = 0; i < count; ++i) out.push_back({static_cast<std::uint8_t>(offset + i), 0});
  return out;
}

std::vector<Stroke::Byte> all_of(std::initializer_list<std::vector<Stroke::Byte>> parts) {
  std::vector<Stroke::Byte> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

std::vector<Stroke> pair_strokes() {
  const auto upright = all_of({{{1, 0}, {29, 0}}, zeros(12, 12), zeros(40, 12)});
  return {{"coaxial", all_of({upright, zeros(56, 4)})},
          {"side by side", all_of({upright, {{56, 6 << 2}}, zeros(57, 7)})},
          {"parallel", upright},
          {"touching", {{64, 0}, {66, 1}, {67, 0}}},
          {"nearly touching", {{64, 0}, {66, 13}, {67, 0}}},
          {"concentric", {{64, 2}, {66, 255}, {67, 255}}},
          {"nearly concentric", {{64, 2}, {66, 254}, {67, 255}}},
          {"at home", {{68, 0}, {70, 0}}}};
}

/// Where the contact is near to on both bodies, without a tilt; 9: the face across z, 10: an edge, 13: a corner.
std::vector<Stroke::Byte> places(std::uint8_t one, std::uint8_t two) {
  return all_of({{{1, one}, {29, two}}, zeros(12, 3), zeros(40, 3)});
}

std::vector<Stroke> contact_strokes() {
  return {{"pole on pole", places(9, 9)},
          {"edge on edge", places(10, 10)},
          {"corner on face", places(13, 9)},
          {"edge on face", places(10, 9)},
          {"touching", {{60, 0}, {62, 1}, {63, 0}}},
          {"nearly touching", {{60, 0}, {62, 13}, {63, 0}}},
          {"not turned", zeros(68, 12)},
          {"no spin", zeros(56, 4)},
          {"coaxial", all_of({places(9, 9), zeros(56, 4), zeros(68, 12)})},
          {"at home", {{64, 0}, {66, 0}}}};
}

constexpr std::uint8_t kShapeBlock = 44;

std::vector<ByteField> shapes_fields() {
  std::vector<ByteField> fields{
      {88, 1, FieldKind::choice},     {89, 1, FieldKind::choice},  {90, 2, FieldKind::magnitude},
      {92, 4, FieldKind::angle},      {96, 1, FieldKind::choice},  {98, 2, FieldKind::magnitude},
      {100, 1, FieldKind::choice},    {101, 1, FieldKind::number}, {102, 1, FieldKind::choice},
      {103, 1, FieldKind::number},    {104, 1, FieldKind::choice}, {105, 1, FieldKind::choice},
      {106, 2, FieldKind::magnitude}, {108, 4, FieldKind::angle}};
  for (const std::uint8_t at : {std::uint8_t{0}, kShapeBlock})
    for (const ByteField& field : std::initializer_list<ByteField>{{0, 1, FieldKind::choice},
                                                                   {1, 1, FieldKind::choice},
                                                                   {2, 2, FieldKind::scale},
                                                                   {4, 2, FieldKind::scale},
                                                                   {6, 2, FieldKind::scale},
                                                                   {8, 2, FieldKind::scale},
                                                                   {10, 2, FieldKind::scale},
                                                                   {12, 4, FieldKind::angle},
                                                                   {16, 4, FieldKind::angle},
                                                                   {20, 4, FieldKind::angle},
                                                                   {24, 4, FieldKind::number},
                                                                   {28, 2, FieldKind::scale},
                                                                   {30, 1, FieldKind::number},
                                                                   {31, 1, FieldKind::choice},
                                                                   {32, 4, FieldKind::number},
                                                                   {36, 2, FieldKind::scale},
                                                                   {38, 2, FieldKind::scale},
                                                                   {40, 2, FieldKind::scale}})
      fields.push_back({static_cast<std::uint8_t>(at + field.offset), field.width, field.kind});
  return fields;
}

std::vector<Stroke> shapes_strokes() {
  const auto upright = all_of({{{1, 0}, {89, 0}}, zeros(12, 12), zeros(90, 2), {{104, 2}, {105, 0}}});
  return {{"coaxial", all_of({upright, {{88, 2}}})},
          {"face on face", all_of({upright, {{88, 0}}})},
          {"aligned", {{104, 2}}},
          {"nearly aligned", {{104, 3}}},
          {"touching", {{88, 0}, {96, 0}, {98, 1}, {99, 0}}},
          {"nearly touching", {{88, 0}, {96, 0}, {98, 13}, {99, 0}}},
          {"concentric", {{88, 2}, {96, 2}, {98, 255}, {99, 255}}},
          {"sharp", all_of({zeros(28, 2), zeros(72, 2)})},
          {"a plate", {{6, 13}, {7, 0}}},
          {"at home", {{100, 0}, {102, 0}}}};
}

}  // namespace

const Layout& pair_layout() {
  static const Layout layout{"pair-1", kPairLayoutSize, pair_fields(), pair_strokes(), kBodySize};
  return layout;
}

const Layout& path_layout() {
  static const Layout layout{"path-1", kPathLayoutSize, path_fields(), pair_strokes(), kBodySize};
  return layout;
}

const Layout& contact_layout() {
  static const Layout layout{"contact-1", kContactLayoutSize, contact_fields(), contact_strokes(), kBodySize};
  return layout;
}

const Layout& shapes_layout() {
  static const Layout layout{"shapes-1", kShapesLayoutSize, shapes_fields(), shapes_strokes(), kShapeBlock};
  return layout;
}

}  // namespace plumb

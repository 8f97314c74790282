// What a file becomes when it is edited badly: one place of it at a time is gone, of another type or out of range. Its reader
// takes that, or tells it in one line of its own words that begins with the file's name.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "corpus/case/case.hpp"

namespace plumb {

/// Elements of an array, or of an object whose members have numbers for names: what is read of one is read of each.
inline bool has_elements(const Json& tree) {
  if (!tree.is_object()) return tree.is_array();
  const auto items = tree.items();
  return std::all_of(items.begin(), items.end(),
                     [](const auto& item) { return item.key().find_first_not_of("-0123456789") == std::string::npos; });
}

/// Of many elements the first two and the last stand for the others.
inline void collect_places(const Json& tree, const Json::json_pointer& here, std::vector<Json::json_pointer>& out) {
  out.push_back(here);
  if (!tree.is_structured()) return;
  const bool are_alike = has_elements(tree);
  std::size_t i = 0;
  for (const auto& [key, value] : tree.items()) {
    if (!are_alike || i < 2 || i + 1 == tree.size()) collect_places(value, here / key, out);
    ++i;
  }
}

/// Values as text, so that there may be what JSON has not.
inline std::vector<std::string> bad_values() {
  return {"null",
          "true",
          "\"x\"",
          "\"\"",
          "-1",
          "0",
          "0.5",
          "1e300",
          "18446744073709551615",
          "9007199254740993",
          "[]",
          "{}",
          "[1]",
          "NaN",
          "1e999",
          "[null]",
          "{\"x\": 1}",
          std::string(1000, '[')};
}

inline std::string with_text_at(Json tree, const Json::json_pointer& place, const std::string& value) {
  const std::string mark = "\"@ here @\"";
  tree[place] = Json::parse(mark);
  std::string text = tree.dump();
  return text.replace(text.find(mark), mark.size(), value);
}

inline Json without(Json tree, const Json::json_pointer& place) {
  Json& above = tree[place.parent_pointer()];
  if (above.is_object())
    above.erase(place.back());
  else
    above.erase(std::stoul(place.back()));
  return tree;
}

/// Hands out each broken text; `tree` is a whole file, or one line of it.
inline void each_broken(const Json& tree, const std::function<void(const std::string&)>& use) {
  std::vector<Json::json_pointer> places;
  collect_places(tree, Json::json_pointer(), places);
  for (const auto& place : places) {
    for (const std::string& value : bad_values()) use(with_text_at(tree, place, value));
    if (!place.empty()) use(without(tree, place).dump());
  }
  const std::string text = tree.dump();
  constexpr std::size_t cuts = 50;
  for (std::size_t i = 0; i < cuts; ++i) use(text.substr(0, i * text.size() / cuts));
}

inline std::string excerpt(const std::string& text) {
  return text.size() < 2000 ? text : text.substr(0, 2000) + "..";
}

/// `file` is how the line must begin.
inline void expect_read_or_told(const std::string& file, const std::string& text, const std::function<void()>& read) {
  try {
    read();
  } catch (const InputFailure& e) {
    const std::string line = e.what();
    EXPECT_TRUE(line.starts_with(file + ":")) << line << "\n" << excerpt(text);
    EXPECT_EQ(line.find("exception"), std::string::npos) << line << "\n" << excerpt(text);
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  } catch (const std::exception& e) {
    ADD_FAILURE() << e.what() << "\n" << excerpt(text);
  }
}

inline void expect_all_read_or_told(const std::string& file, const Json& tree,
                                    const std::function<void(const std::string& text)>& read) {
  each_broken(tree, [&](const std::string& text) { expect_read_or_told(file, text, [&] { read(text); }); });
}

}  // namespace plumb

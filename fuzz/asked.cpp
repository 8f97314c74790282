#include "fuzz/asked.hpp"

namespace plumb {

Json Asked::to_json() const {
  return {{"seed", seed}, {"cases", cases}, {"methods", methods}, {"shards", shards}, {"done", done}};
}

Asked Asked::from_json(const Json& json) {
  Asked asked;
  json.at("seed").get_to(asked.seed);
  json.at("cases").get_to(asked.cases);
  json.at("methods").get_to(asked.methods);
  json.at("shards").get_to(asked.shards);
  json.at("done").get_to(asked.done);
  if (asked.done.empty() || *asked.done.begin() < 1 || *asked.done.rbegin() > asked.shards)
    throw FieldError("asked.done", "is not a list of shards out of 1 to asked.shards");
  return asked;
}

}  // namespace plumb

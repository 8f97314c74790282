#include "fuzz/campaign/request.hpp"

#include "corpus/json/fields.hpp"

namespace plumb {

Json Asked::to_json() const {
  return {{"seed", seed},         {"cases", cases},   {"methods", methods},
          {"accuracy", accuracy}, {"shards", shards}, {"done", done}};
}

Asked Asked::read(const Field& field) {
  Asked asked;
  asked.seed = field.member("seed").natural();
  for (const auto& [family, cases] : field.member("cases").members()) asked.cases[family] = cases.natural();
  for (const Field& method : field.member("methods").elements()) asked.methods.insert(method.text());
  asked.accuracy = field.member("accuracy").text();
  asked.shards = field.member("shards").natural();
  const Field done = field.member("done");
  for (const Field& shard : done.elements()) asked.done.insert(shard.natural());
  if (asked.done.empty() || *asked.done.begin() < 1 || *asked.done.rbegin() > asked.shards)
    done.fail("is not a list of shards out of 1 to asked.shards");
  return asked;
}

}  // namespace plumb

#include "corpus/solvers/host/solve_line.hpp"

#include "corpus/case/answer.hpp"
#include "corpus/case/case.hpp"
#include "corpus/solvers/abilities.hpp"
#include "solver/c/door.hpp"

namespace plumb {
namespace {

void require_number(const Field& reply, std::uint64_t number) {
  const Field said = reply.member("number");
  if (said.natural() != number) said.fail("is not that of the request");
}

}  // namespace

std::string request_line(const wire::Request& request) {
  Json out;
  out["format"] = "plumb/solve-1";
  out["number"] = request.number;
  out["bodies"] = bodies_json(door::pair_of(request.pair));
  if (request.kind == wire::Request::Kind::solve_warm) out["last"] = contact_json(door::contact_of(request.last), {});
  return write_json(out);
}

void read_hello(const std::string& line, wire::Hello& hello) {
  const Json tree = read_json(line);
  const Abilities abilities = read_abilities(Field(tree));
  plumb_abilities& out = hello.abilities;
  out.size = sizeof out;
  out.shapes = static_cast<int>(abilities.shapes);
  out.exponents[0] = abilities.exponents[0];
  out.exponents[1] = abilities.exponents[1];
  out.apart = static_cast<int>(abilities.apart);
  out.points = static_cast<int>(abilities.points);
  out.normal = abilities.normal ? 1 : 0;
  out.problem = static_cast<int>(abilities.problem);
  out.tolerance = abilities.tolerance;
  hello.name.set(abilities.name);
  hello.version.set(abilities.version);
  hello.licence.set(abilities.licence);
  hello.warm = abilities.warm;
  hello.loaded = true;
}

wire::Reply read_reply(const std::string& line, std::uint64_t number) {
  const Json tree = read_json(line);
  const Field reply(tree);
  reply.require_object({"number", "refused", "ns", "status", "verdict", "overlap", "normal", "points", "contact_point",
                        "iterations", "evaluations"});
  require_number(reply, number);
  wire::Reply out;
  if (const auto refused = reply.find("refused"); refused && refused->flag())
    out.kind = wire::Reply::Kind::refused;
  else
    out.contact = door::c_contact(read_contact(reply));
  if (const auto time = reply.find("ns")) out.nanoseconds = time->number();
  return out;
}

}  // namespace plumb

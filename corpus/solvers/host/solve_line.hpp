// The lines that plumb and a foreign program say to each other (--solver-command): one JSON object each, UTF-8, one request and one
// reply after the other. The first line is the program's: its abilities (abilities.hpp).
//
// Request  { "format": "plumb/solve-1", "number": 7, "bodies": [ .. as in a case file .. ], "last": { an answer } }
//          last: the contact of the same bodies a step before; for programs that claim "warm", and not always.
// Reply    { "number": 7, .. the fields of an answer .. }   or   { "number": 7, "refused": true }
//          number: that of the request. ns, optional: nanoseconds that the solve took; without it the round trip counts.
// Answer   status, verdict, overlap, normal, points, contact_point, iterations, evaluations: those of `plumb solve`. What is missing
//          or null is not known; without status it is "converged", without verdict that of the overlap.
#pragma once

#include <string>

#include "corpus/solvers/solver_wire.hpp"

namespace plumb {

/// Without a line feed, each number as the shortest decimal that reads back to the same double.
[[nodiscard]] std::string request_line(const wire::Request& request);

/// Fills what a program said of itself. Throws FieldError.
void read_hello(const std::string& line, wire::Hello& hello);

/// The reply to a request of that number. Throws FieldError.
[[nodiscard]] wire::Reply read_reply(const std::string& line, std::uint64_t number);

}  // namespace plumb

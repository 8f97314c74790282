// The door of WebAssembly: every row of the method table, over the block of block.hpp. Nothing is allocated.
#include <array>

#include "solver/contact.hpp"
#include "solver/diagnosis.hpp"
#include "solver/js/wasm/block.hpp"
#include "solver/method/methods.hpp"

namespace {

using namespace plumb::js;

/// Fills the outputs, number by number.
class Writer {
 public:
  void put(double x) { block[at_++] = x; }
  void put(const plumb::Vec3<double>& v) {
    for (const double x : v) put(x);
  }

 private:
  std::size_t at_ = inputs;
};

void write_diagnosis(Writer& out, const plumb::Pair& pair, const plumb::Contact<double>& c) {
  const plumb::Diagnosis d = plumb::diagnose(pair, c.point1, c.point2, c.overlap < 0 ? -1 : 1);
  for (const double r : d.residues) out.put(r);
  for (const double angle : {d.d_n1, d.d_n2, d.n1_n2}) out.put(angle);
  const plumb::ContactNormals normals = plumb::normals_at(pair, c.point1, c.point2);
  out.put(normals.normal1);
  out.put(normals.normal2);
  out.put(static_cast<double>(plumb::fails_of(d)));
}

}  // namespace

// Exported; the linker keeps what solver/js/build names.
extern "C" {

double* plumb_js_block() {
  return block.data();
}

int plumb_js_count() {
  return static_cast<int>(plumb::methods().size());
}

/// Field 0..6 of a row: name, problem, who published it, summary, colour on a light page and on a dark one, symbol. Literals, so
/// they end in a zero.
const char* plumb_js_text(int method, int field) {
  const plumb::Method& row = plumb::methods()[static_cast<std::size_t>(method)];
  const std::array texts{row.name,       name(row.problem), row.published_by, row.summary,
                         row.look.light, row.look.dark,     row.look.symbol};
  return texts[static_cast<std::size_t>(field)].data();
}

const char* plumb_js_status(int status) {
  return name(static_cast<plumb::Status>(status)).data();
}

const char* plumb_js_verdict(int verdict) {
  return name(static_cast<plumb::Verdict>(verdict)).data();
}

/// What is wrong with the pair: the field (0), or the reason (1); "" where it is legal.
const char* plumb_js_input_error(int part) {
  const plumb::InputError error = plumb::find_input_error(given());
  const std::string_view text = part == 0 ? error.field : error.reason;
  return text.empty() ? "" : text.data();
}

/// Which body is wrong then, 0 or 1; -1: the pair.
int plumb_js_input_body() {
  return plumb::find_input_error(given()).body;
}

/// Solves the block's pair; `diagnosed`: with what its points say of themselves.
void plumb_js_solve(int method, int diagnosed, int iteration_limit, double tolerance) {
  const plumb::Pair pair = given();
  plumb::Want want;
  want.iteration_limit = iteration_limit;
  want.tolerance = tolerance;
  const plumb::Contact<double> c = plumb::methods()[static_cast<std::size_t>(method)].solve(pair, want, nullptr);
  Writer out;
  out.put(static_cast<double>(c.status));
  out.put(static_cast<double>(c.verdict));
  out.put(c.overlap);
  for (const plumb::Vec3<double>& v : {c.normal, c.point1, c.point2, c.contact_point}) out.put(v);
  out.put(c.iterations);
  out.put(c.evaluations);
  if (diagnosed != 0 && c.status == plumb::Status::converged) write_diagnosis(out, pair, c);
}

}  // extern "C"

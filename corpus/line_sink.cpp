#include "corpus/line_sink.hpp"

#include <cerrno>

#include "corpus/case.hpp"
#include "corpus/command.hpp"

namespace plumb {

LineSink::LineSink(std::string file) : file_(std::move(file)) {
  if (file_.empty()) return;
  out_.open(file_, std::ios::binary);
  if (!out_) fail_with(file_, errno);
}

void LineSink::add(const std::string& text) {
  if (file_.empty()) return print_line(text);
  if (!(out_ << text << '\n')) fail_with(file_, errno);
}

void LineSink::flush() {
  if (file_.empty()) return flush_output();
  if (!out_.flush()) fail_with(file_, errno);
}

}  // namespace plumb

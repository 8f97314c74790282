#include "corpus/command/line_sink.hpp"

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"

namespace plumb {

LineSink::LineSink(const std::string& file) {
  if (!file.empty()) file_.emplace(file);
}

void LineSink::add(const std::string& text) {
  constexpr std::size_t many = 1 << 16;
  if (!file_) return print_line(text);
  pending_ += text + "\n";
  if (pending_.size() >= many) flush();
}

void LineSink::flush() {
  if (!file_) return flush_output();
  file_->write(pending_);
  pending_.clear();
}

void LineSink::finish() {
  flush();
  if (!file_) return;
  if (interrupted())
    file_->finish_incomplete();
  else
    file_->finish();
}

}  // namespace plumb

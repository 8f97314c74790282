#include "corpus/command.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

#include "corpus/case.hpp"
#include "corpus/interrupt.hpp"

namespace plumb {
namespace {

int refuse(std::string reason) {
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  (void)std::fprintf(stderr, "%s\n", reason.c_str());
  return exit_unusable;
}

[[noreturn]] void fail_output(int error) {
  throw InputFailure("standard output", 0, "", std::strerror(error));
}

// Help and version are exceptions of the library, too; they print and end with 0.
int refuse_usage(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  return refuse(app.get_name() + ": " + error.what() + " (--help tells more)");
}

int run_body(const std::function<int()>& body) {
  const int code = body();
  if (std::fflush(stdout) != 0) fail_output(errno);
  return interrupted() ? static_cast<int>(exit_interrupted) : code;
}

}  // namespace

int run_command(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  try {
    app.parse(argc, argv);
    catch_interrupt();
    return run_body(body);
  } catch (const CLI::ParseError& error) {
    return refuse_usage(app, error);
  } catch (const InputFailure& error) {
    (void)std::fflush(stdout);
    // What broke the input may have been the interrupt.
    return interrupted() ? static_cast<int>(exit_interrupted) : refuse(error.what());
  } catch (const std::exception& error) {
    (void)std::fflush(stdout);
    return refuse(app.get_name() + ": " + error.what());
  }
}

void print_line(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fputc('\n', stdout) == EOF) fail_output(errno);
}

}  // namespace plumb

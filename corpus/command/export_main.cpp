// plumb export: cases or a scene as a dump, for who looks at them in OVITO or goes on in LAMMPS.
#include <fmt/format.h>

#include <array>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/line_sink.hpp"
#include "corpus/dump/dump_text.hpp"
#include "corpus/json/fields.hpp"
#include "corpus/json/object_reader.hpp"
#include "corpus/scene/scene_file.hpp"
#include "solver/scene/body/mass.hpp"

namespace plumb {
namespace {

struct Arguments {
  std::string file, format = "lammps", out;
};

void declare(CommandLine& app, Arguments& arguments) {
  app.add_option("FILE", arguments.file, "cases, a scene, or - for standard input")->required();
  app.add_option("--format", arguments.format, "whose columns")
      ->is_one_of("format", {"lammps", "liggghts"})
      ->capture_default_str();
  app.add_option("-o", arguments.out, "file for the dump; else standard output");
}

/// What is wrong with a body that no dump would give back, or nothing.
std::string refusal_of(const Body& body) {
  constexpr double farthest = 1e100;  // where the reader of dumps ends
  if (!(body.position.cwiseAbs().maxCoeff() <= farthest)) return "position";
  return 2 * body.shape.semi_axes.maxCoeff() <= farthest ? "" : "shape.superellipsoid.semi_axes";
}

class Exporter {
 public:
  explicit Exporter(const Arguments& arguments)
      : format_(arguments.format == "lammps" ? DumpFormat::lammps : DumpFormat::liggghts),
        reader_(arguments.file, ObjectReader::layout_of(arguments.file)), sink_(arguments.out) {}

  int run() {
    while (!interrupted()) {
      const auto text = reader_.next();
      if (!text) break;
      if (is_scene(*text))
        add_scene(scene::parse_scene(*text, reader_.file()).scene);
      else
        add_case(parse_case(*text, reader_.file(), reader_.line()));
    }
    if (frames_ == 0 && !interrupted()) throw InputFailure(reader_.file(), 0, "", "holds no case and no scene");
    if (frames_ > 0) sink_.finish();
    return exit_done;
  }

 private:
  /// Which reader says what is wrong with it.
  static bool is_scene(const std::string& text) {
    try {
      const Json tree = read_json(text);
      const auto format = Field(tree).find("format");
      return format && format->value() == "plumb/scene-1";
    } catch (const FieldError&) {
      return false;
    }
  }

  void add_case(const Case& c) { add({c.pair.body1, c.pair.body2}, std::array{1, 2}); }

  void add_scene(const scene::Scene& scene) {
    std::vector<Body> bodies;
    std::vector<int> types;
    for (const scene::SceneBody& b : scene.bodies) {
      bodies.push_back(b.body);
      types.push_back(b.is_fixed ? 2 : 1);
    }
    add(bodies, types);
    if (!scene.walls.empty())
      fmt::print(stderr, "{}: {} walls left out: a dump holds none\n", reader_.file(), scene.walls.size());
  }

  void add(const std::vector<Body>& bodies, std::span<const int> types) {
    DumpBounds bounds;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const std::string field = refusal_of(bodies[i]);
      if (!field.empty())
        throw InputFailure(reader_.file(), reader_.line(), fmt::format("bodies[{}].{}", i, field), "is beyond 1e100");
      bounds.include(bodies[i].position, scene::bounding_radius(bodies[i].shape));
    }
    std::string text = dump_head(frames_++, {}, bodies.size(), bounds, dump_column_names(format_));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      add_dump_body(text, format_, i + 1, types[i], bodies[i]);
      text += "\n";
    }
    text.pop_back();
    sink_.add(text);
  }

  DumpFormat format_;
  ObjectReader reader_;
  LineSink sink_;
  std::int64_t frames_ = 0;
};

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments arguments;
  plumb::CommandLine app("Cases, a frame each, or a scene's first state as a dump for LAMMPS, LIGGGHTS and OVITO.",
                         "plumb export");
  plumb::declare(app, arguments);
  return plumb::run_command(app, argc, argv, [&] { return plumb::Exporter(arguments).run(); });
}

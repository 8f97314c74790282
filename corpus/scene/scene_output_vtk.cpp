// vtk/: XML PolyData, a file a frame, and an index of them with their times. Bodies carry the columns of
// rotation * diag(diameters) as "axes" (nine numbers, an axis after the other): Tensor Glyph draws them with Extract Eigenvalues
// off, and roundness_phi and roundness_theta are those of VTK's superquadric about its z axis.
#include <fmt/format.h>

#include <functional>

#include "corpus/scene/scene_output.hpp"
#include "corpus/scene/scene_view.hpp"
#include "solver/pose.hpp"

namespace plumb::scene {
namespace {

/// The numbers of a point array, a point a line.
struct PointArray {
  std::string name;
  int width;
  std::function<void(std::string& text, std::size_t point)> add;
};

void add_numbers(std::string& text, std::span<const double> numbers) {
  for (const double x : numbers) text += shortest(x) + " ";
}

void add_numbers(std::string& text, const Vec3<double>& v) {
  add_numbers(text, std::span(v.data(), 3));
}

std::string array_text(const PointArray& array, std::size_t points) {
  const std::string name = array.name.empty() ? "" : fmt::format(" Name=\"{}\"", array.name);
  std::string out =
      fmt::format("<DataArray type=\"Float64\"{} NumberOfComponents=\"{}\" format=\"ascii\">\n", name, array.width);
  for (std::size_t i = 0; i < points; ++i) {
    array.add(out, i);
    out += "\n";
  }
  return out + "</DataArray>\n";
}

/// A vertex for each point.
std::string vertices_text(std::size_t points) {
  std::string connectivity, offsets;
  for (std::size_t i = 0; i < points; ++i) {
    connectivity += std::to_string(i) + " ";
    offsets += std::to_string(i + 1) + " ";
  }
  return "<Verts>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n" + connectivity +
         "\n</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n" + offsets +
         "\n</DataArray>\n</Verts>\n";
}

std::string polydata_text(double time, std::size_t points, const PointArray& places,
                          std::span<const PointArray> arrays) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n";
  out +=
      "<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">";
  out += shortest(time) + "</DataArray>\n</FieldData>\n";
  out += fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\">\n", points);
  out += "<Points>\n" + array_text(places, points) + "</Points>\n" + vertices_text(points) + "<PointData>\n";
  for (const PointArray& array : arrays) out += array_text(array, points);
  return out + "</PointData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

PointArray of_column(std::string name, const Column& column) {
  return {std::move(name), static_cast<int>(column.width()),
          [&column](std::string& text, std::size_t i) { add_numbers(text, column.entry(i)); }};
}

std::vector<PointArray> arrays_of_bodies(const World& world) {
  const auto& shape = world.bodies.shape;
  const Column& turned = *world.state.orientation;
  const auto semi_axes = [&](std::string& text, std::size_t i) { add_numbers(text, shape[i].semi_axes); };
  const auto exponents = [&](std::string& text, std::size_t i) {
    add_numbers(text, std::array{shape[i].n1, shape[i].n2});
  };
  const auto axes = [&](std::string& text, std::size_t i) {
    const auto q = turned.entry(i);
    const Mat3<double> r = rotation<double>({q[0], q[1], q[2], q[3]});
    for (int k = 0; k < 3; ++k) add_numbers(text, Vec3<double>(r.col(k) * (2 * shape[i].semi_axes[k])));
  };
  std::vector<PointArray> out{{"semi_axes", 3, semi_axes}, {"exponents", 2, exponents}, {"axes", 9, axes}};
  out.push_back({"roundness_phi", 1, [&](auto& text, auto i) { add_numbers(text, std::array{2 / shape[i].n1}); }});
  out.push_back({"roundness_theta", 1, [&](auto& text, auto i) { add_numbers(text, std::array{2 / shape[i].n2}); }});
  out.push_back(of_column("quaternion_wxyz", turned));
  if (world.state.velocity != nullptr) out.push_back(of_column("velocity", *world.state.velocity));
  if (const Column* temperature = world.columns.find("temperature"))
    out.push_back(of_column("temperature", *temperature));
  return out;
}

std::string bodies_text(const Simulation& run) {
  const World& world = run.world();
  const PointArray places{
      "", 3, [&](std::string& text, std::size_t i) { add_numbers(text, world.home(world.state.position->vector(i))); }};
  return polydata_text(run.time(), world.bodies.count, places, arrays_of_bodies(world));
}

std::string contacts_text(const Simulation& run) {
  const std::vector<ContactView> contacts = contacts_of(run);
  const PointArray places{
      "", 3, [&](std::string& text, std::size_t i) { add_numbers(text, run.world().home(contacts[i].point)); }};
  std::vector<PointArray> arrays;
  arrays.push_back({"normal", 3, [&](auto& text, auto i) { add_numbers(text, contacts[i].normal); }});
  arrays.push_back({"overlap", 1, [&](auto& text, auto i) { add_numbers(text, std::array{contacts[i].overlap}); }});
  arrays.push_back({"force", 3, [&](std::string& text, std::size_t i) {
                      add_numbers(text, Vec3<double>(contacts[i].force.value_or(0) * contacts[i].normal));
                    }});
  return polydata_text(run.time(), contacts.size(), places, arrays);
}

class Vtk : public SceneOutput {
 public:
  using ToText = std::string (*)(const Simulation&);
  Vtk(const std::filesystem::path& folder, std::string what, std::uint64_t length, ToText to_text)
      : SceneOutput(folder, "vtk/" + what + ".pvd", length), folder_(folder / "vtk"), what_(std::move(what)),
        to_text_(to_text) {
    if (length == 0)
      file().add("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n");
    file().set_tail("</Collection>\n</VTKFile>\n");
  }

  void frame(const Simulation& run) override {
    const std::string name = fmt::format("{}_{:010}.vtp", what_, run.steps());
    AppendFile frame(folder_ / name, 0);
    frame.add(to_text_(run));
    frame.flush();
    file().add(fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", shortest(run.time()), name));
  }

 private:
  std::filesystem::path folder_;
  std::string what_;
  ToText to_text_;
};

}  // namespace

OpenedOutput open_vtk_bodies(const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Vtk>(folder, "bodies", length, bodies_text);
}

OpenedOutput open_vtk_contacts(const std::filesystem::path& folder, std::uint64_t length) {
  return std::make_unique<Vtk>(folder, "contacts", length, contacts_text);
}

}  // namespace plumb::scene

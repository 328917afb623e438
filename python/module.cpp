// The compiled part of the Python package `ar3d`; python/ar3d/__init__.py is what users import.
#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/apps/view.h"
#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/drawings/embedding.h"
#include "ar3d/formats/graphs/list_graph.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"

namespace ar3d {
namespace {

namespace py = pybind11;

constexpr const char* kNoPoints = "points are integers, an array of shape (k, 3)";
using Values = std::map<std::string, std::int64_t>;

Settings settings_of(const Values& values) {
  Settings settings;
  for (const auto& [name, value] : values) settings.push_back({name, value});
  return settings;
}

/// @throws InputError if the system would cut the name at a byte 0.
const std::string& whole(const std::string& path) {
  if (path.find('\0') == std::string::npos) return path;
  throw InputError("the name of a file has a byte 0: '" + path.substr(0, path.find('\0')) + "…'");
}

/// An object of a class without a constructor, made past C++, would be read uninitialised.
template <class Class>
void refuse_new(Class& made_here) {
  made_here.def_static("__new__", [](const py::handle& type, const py::args&, const py::kwargs&) {
    throw py::type_error(py::str(type.attr("__name__")).cast<std::string>() +
                         " has no constructor; ar3d makes it");
  });
}

/// An array over memory that `owner` keeps alive, not to be written to.
template <class Number, class Owner>
py::array_t<Number> view(std::vector<py::ssize_t> shape, const Number* data,
                         const std::shared_ptr<Owner>& owner) {
  const py::capsule keeper(new std::shared_ptr<Owner>(owner),
                           [](void* kept) { delete static_cast<std::shared_ptr<Owner>*>(kept); });
  py::array_t<Number> array(std::move(shape), data, keeper);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// The vector becomes the array's memory.
template <class Number>
py::array_t<Number> array_of(std::vector<Number> values, std::vector<py::ssize_t> shape) {
  const auto kept = std::make_shared<const std::vector<Number>>(std::move(values));
  return view(std::move(shape), kept->data(), kept);
}

py::array_t<std::uint32_t> edges_of(const std::shared_ptr<const std::vector<Edge>>& edges) {
  static_assert(sizeof(Edge) == 2 * sizeof(Vertex));
  return view<Vertex>({static_cast<py::ssize_t>(edges->size()), 2},
                      edges->empty() ? nullptr : &edges->data()->u, edges);
}

/// @param pairs  shape (m, 2).
Graph graph_of(std::uint64_t num_vertices, const py::array_t<std::int64_t>& pairs) {
  if (pairs.ndim() != 2 || pairs.shape(1) != 2) {
    throw InputError("edges are an array of shape (m, 2)");
  }
  const auto at = pairs.unchecked<2>();
  std::vector<Edge> edges;
  edges.reserve(static_cast<std::size_t>(at.shape(0)));
  const auto end_of = [&](py::ssize_t e, py::ssize_t side) {
    const std::int64_t id = at(e, side);
    if (id >= 0 && static_cast<std::uint64_t>(id) < num_vertices && id < INT64_C(4294967295)) {
      return static_cast<Vertex>(id);
    }
    const std::string range = num_vertices == 0
                                  ? "there are no vertices"
                                  : fmt::format("vertices are 0 to {}", num_vertices - 1);
    throw InputError(fmt::format("edge {} has the vertex {}, but {}", e, id, range));
  };
  for (py::ssize_t e = 0; e < at.shape(0); ++e) edges.push_back({end_of(e, 0), end_of(e, 1)});
  const py::gil_scoped_release released;
  return {num_vertices, std::move(edges)};
}

/// A drawing with its points as Python reads them.
struct PythonDrawing {
  Drawing drawing;
  std::vector<std::int64_t> vertices;  ///< x, y, z of each
  std::vector<std::int64_t> offsets;   ///< of the bends of every edge, in order of edge numbers
  std::vector<std::int64_t> bends;     ///< x, y, z of each
  Box box;
};

void append(Point p, std::vector<std::int64_t>& to) { to.insert(to.end(), {p.x, p.y, p.z}); }

std::shared_ptr<PythonDrawing> with_points(Drawing drawing) {
  if (drawing.real != nullptr) {
    throw InputError("algorithm " + drawing.algorithm() +
                     " draws in a real type, which has no integers");
  }
  auto made = std::make_shared<PythonDrawing>(PythonDrawing{std::move(drawing), {}, {}, {}, {}});
  for (Vertex v = 0; v < made->drawing.num_vertices(); ++v) {
    append(made->drawing.vertex(v), made->vertices);
  }
  made->offsets.push_back(0);
  for_each_polyline(made->drawing, [&](EdgeId, const std::vector<Point>& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) append(points[i], made->bends);
    made->offsets.push_back(static_cast<std::int64_t>(made->bends.size() / 3));
  });
  made->box = bounding_box(made->drawing);
  return made;
}

/// @param names  of the vertices; none: their numbers.
std::shared_ptr<PythonDrawing> draw_graph(const Graph& graph, const std::string& algorithm,
                                          const Values& options, std::vector<std::string> names) {
  const py::gil_scoped_release released;
  Drawing drawing = draw(find_algorithm(algorithm), graph, settings_of(options));
  names = telling_names(std::move(names));
  if (!names.empty()) {
    drawing.names = std::make_shared<const std::vector<std::string>>(std::move(names));
  }
  return with_points(std::move(drawing));
}

/// The drawings of a text of JSON lines, named `place` in messages.
std::vector<std::shared_ptr<PythonDrawing>> drawings_in(TextInput input) {
  const py::gil_scoped_release released;
  DrawingJsonlReader reader(std::move(input));
  std::vector<std::shared_ptr<PythonDrawing>> drawings;
  while (std::optional<DrawingJsonlReader::Line> line = reader.next()) {
    if (const auto* undrawn = std::get_if<UndrawnGraph>(&*line)) {
      throw InputError(reader.where() + ": it was not drawn: " + undrawn->error);
    }
    drawings.push_back(with_points(std::get<Drawing>(std::move(*line))));
  }
  return drawings;
}

std::string line_of(const PythonDrawing& drawing) {
  std::string line;
  append_drawing_line(line, drawing.drawing);
  return line;
}

/// The only graph of a reader with its vertices' names; what is assumed becomes a warning.
std::pair<Graph, std::vector<std::string>> only_graph(GraphReader reader, const std::string& what) {
  std::optional<Graph> graph = reader.next();
  std::vector<std::string> names = reader.names();
  if (reader.next()) throw InputError(what + " holds several graphs; one is wanted");
  for (const std::string& note : reader.take_notes()) {
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 2) != 0) throw py::error_already_set();
  }
  return {std::move(*graph), std::move(names)};
}

/// One of the drawing's lists, shared with it.
py::array_t<std::int64_t> list_of(const std::shared_ptr<PythonDrawing>& drawing,
                                  const std::vector<std::int64_t>& list, bool is_of_points) {
  const auto size = static_cast<py::ssize_t>(list.size());
  const std::vector<py::ssize_t> shape =
      is_of_points ? std::vector<py::ssize_t>{size / 3, 3} : std::vector<py::ssize_t>{size};
  return view<std::int64_t>(shape, list.data(), drawing);
}

/// @param points  shape (k, 3).
std::vector<Point> points_of(const py::array_t<std::int64_t>& points) {
  if (points.ndim() != 2 || points.shape(1) != 3) throw InputError(kNoPoints);
  const auto at = points.unchecked<2>();
  std::vector<Point> list;
  for (py::ssize_t i = 0; i < at.shape(0); ++i) list.push_back({at(i, 0), at(i, 1), at(i, 2)});
  return list;
}

/// Lattice points as points of space, where angles are true.
py::array_t<double> in_space(const PythonDrawing& drawing, const py::object& list) {
  const auto given = py::array::ensure(list);
  const char kind = given ? given.dtype().kind() : '?';
  if (kind != 'i' && kind != 'u' && !(given && given.size() == 0)) throw InputError(kNoPoints);
  const Embedding embed(drawing.drawing.lattice());
  std::vector<double> placed;
  for (const Point point : points_of(py::array_t<std::int64_t>::ensure(given))) {
    const Real3 p = embed(point);
    placed.insert(placed.end(), {p.x, p.y, p.z});
  }
  const auto count = static_cast<py::ssize_t>(placed.size() / 3);
  return array_of(std::move(placed), {count, 3});
}

void add_graph(py::module_& module) {
  py::class_<Graph> graph(module, "Graph", "A simple undirected graph with vertices 0 to n - 1.");
  // Whole when it is made: what py::init makes could be read before its constructor has run.
  graph.def_static(
      "__new__",
      [](const py::handle&, std::uint64_t num_vertices, const py::array_t<std::int64_t>& edges) {
        return graph_of(num_vertices, edges);
      },
      py::arg("type"), py::arg("num_vertices"), py::arg("edges"));
  graph.attr("__init__") =
      py::cpp_function([](const py::args&, const py::kwargs&) {}, py::is_method(graph));
  graph.def_property_readonly("num_vertices", &Graph::num_vertices);
  graph.def_property_readonly("num_edges", &Graph::num_edges);
  graph.def_property_readonly("max_degree", &Graph::max_degree);
  graph.def_property_readonly("edges", [](const Graph& g) { return edges_of(g.shared_edges()); });
  graph.def("__repr__", [](const Graph& g) {
    return fmt::format("<ar3d.Graph of {} vertices and {} edges>", g.num_vertices(), g.num_edges());
  });
}

py::array_t<std::int64_t> box_of(const PythonDrawing& drawing) {
  const auto [low, high] = drawing.box;
  return array_of<std::int64_t>({low.x, low.y, low.z, high.x, high.y, high.z}, {2, 3});
}

py::array_t<std::int64_t> gram_of(const PythonDrawing& drawing) {
  std::vector<std::int64_t> gram;
  for (const auto& row : drawing.drawing.lattice().gram) append({row[0], row[1], row[2]}, gram);
  return array_of(std::move(gram), {3, 3});
}

Values counters_of(const PythonDrawing& drawing) {
  Values counters;
  for (const Counter& counter : drawing.drawing.counters) counters[counter.name] = counter.value;
  return counters;
}

std::string text_of(const PythonDrawing& drawing) {
  const Drawing& d = drawing.drawing;
  return fmt::format("<ar3d.Drawing of {} vertices, {} edges and {} bends by {}>", d.num_vertices(),
                     d.num_edges(), drawing.bends.size() / 3, d.algorithm());
}

void save(const PythonDrawing& drawing, const std::string& path, const std::string& format,
          bool force) {
  const DrawingFormat& row = drawing_format(format, path);
  if (!force && path != "-" && std::filesystem::exists(whole(path))) {
    PyErr_SetString(PyExc_FileExistsError,
                    (printable(path) + " exists; force=True replaces it").c_str());
    throw py::error_already_set();
  }
  const py::gil_scoped_release released;
  write_drawing(row, drawing.drawing, "the drawing", whole(path));
}

void add_drawing(py::module_& module) {
  using Shared = std::shared_ptr<PythonDrawing>;
  py::class_<PythonDrawing, Shared> drawing(module, "Drawing", "A drawing on integer points.");
  const auto property = [&](const char* name, auto get) {
    drawing.def_property_readonly(name, get);
  };
  property("algorithm", [](const PythonDrawing& d) { return d.drawing.algorithm(); });
  property("edges", [](const PythonDrawing& d) { return edges_of(d.drawing.shared_edges()); });
  property("vertices", [](const Shared& d) { return list_of(d, d->vertices, true); });
  property("bends", [](const Shared& d) { return list_of(d, d->bends, true); });
  property("bend_offsets", [](const Shared& d) { return list_of(d, d->offsets, false); });
  property("box", &box_of);
  property("gram", &gram_of);
  property("gram_denominator",
           [](const PythonDrawing& d) { return d.drawing.lattice().gram_denominator; });
  property("counters", &counters_of);
  drawing.def("in_space", &in_space, py::arg("points"),
              "Integer points (k x 3) as points of space, where angles are true.");
  drawing.def("save", &save, py::arg("path"), py::arg("format") = "", py::arg("force") = false,
              "Writes the drawing; the format is the path's ending or a name of "
              "`ar3d draw --help`. FileExistsError unless force; ValueError.");
  property("names", [](const PythonDrawing& d) {
    return d.drawing.names == nullptr ? std::vector<std::string>() : *d.drawing.names;
  });
  drawing.def("__reduce__", [](const PythonDrawing& d) {
    return py::make_tuple(py::module_::import("ar3d").attr("_unpickled"),
                          py::make_tuple(line_of(d)));
  });
  module.def("unpickled", [](const std::string& line) {
    return drawings_in(TextInput("the pickle", bytes_of(line))).at(0);
  });
  refuse_new(drawing);
  drawing.def("__repr__", [](const PythonDrawing& d) { return text_of(d); });
}

std::vector<std::string> messages_of(const Certificate& certificate) {
  std::vector<std::string> messages;
  for (const Violation& violation : certificate.violations) {
    messages.push_back(std::string(to_string(violation.kind)) + ": " + violation.message);
  }
  return messages;
}

void add_certificate(py::module_& module) {
  py::class_<Certificate> certificate(module, "Certificate",
                                      "What a proof in exact integers found.");
  refuse_new(certificate);
  certificate.def_property_readonly("valid", &Certificate::valid);
  certificate.def_readonly("complete", &Certificate::complete);
  certificate.def_property_readonly("violations", &messages_of);
  certificate.def_readonly("bend_histogram", &Certificate::bend_histogram);
  certificate.def_readonly("segments", &Certificate::segments);
  certificate.def("__bool__", &Certificate::valid);
  certificate.def("__repr__", [](const Certificate& c) {
    const std::string found =
        c.violated() ? std::to_string(c.violations.size()) + " violations" : "proves nothing";
    return "<ar3d.Certificate: " + (c.valid() ? "valid" : found) + ">";
  });
}

Certificate certify_drawing(const Graph& graph, const PythonDrawing& drawing,
                            const std::string& algorithm) {
  const py::gil_scoped_release released;
  return certify(graph, drawing.drawing, find_algorithm(algorithm).guarantee);
}

/// @param cosine  numerator and denominator; 1/1 without `exactly`: every angle will do.
Certificate certify_promise(const Graph& graph, const PythonDrawing& drawing,
                            std::uint32_t max_bends, std::pair<std::int32_t, std::int32_t> cosine,
                            bool exactly) {
  const py::gil_scoped_release released;
  Guarantee promise;
  promise.max_bends = max_bends;
  promise.angle_rule = exactly ? AngleRule::exactly : AngleRule::at_least;
  promise.cosine = {cosine.first, cosine.second};
  promise.lattice = drawing.drawing.lattice();
  return certify(graph, drawing.drawing, promise, {.check_size = false});
}

/// @param bends  shape (k, 3) for every edge.
std::shared_ptr<PythonDrawing> drawing_of(const Graph& graph,
                                          const py::array_t<std::int64_t>& vertices,
                                          const std::vector<py::array_t<std::int64_t>>& bends) {
  std::vector<std::vector<Point>> lists;
  for (const auto& list : bends) lists.push_back(points_of(list));
  return with_points(drawing_from_points("own", graph, points_of(vertices), lists));
}

Graph generate_graph(const std::string& family, std::uint64_t n, std::uint64_t seed,
                     const Values& parameters) {
  const py::gil_scoped_release released;
  return generate(find_family(family), n, seed, settings_of(parameters));
}

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of ar3d.";
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const InputError& error) {
      PyErr_SetString(PyExc_ValueError, printable(error.what()).c_str());
    }
  });
  register_program_formats();
  respect_quota();
  module.attr("__version__") = AR3D_VERSION;
  add_graph(module);
  add_drawing(module);
  add_certificate(module);
  module.def("draw", &draw_graph);
  module.def("load", [](const std::string& path) { return drawings_in(TextInput(whole(path))); });
  module.def("graph_in", [](const std::string& text, const std::string& what) {
    return only_graph(GraphReader(TextInput(what, bytes_of(text + "\n"))), what);
  });
  module.def("graph_of_file",
             [](const std::string& path) { return only_graph(GraphReader(whole(path)), path); });
  module.def("ends_of_heading", [](const std::vector<std::string>& columns) {
    ListRow row;
    for (const std::string& column : columns) row.push_back({column});
    const std::optional<EndColumns> ends = ends_of_heading(row);
    return ends ? std::vector(ends->begin(), ends->end()) : std::vector<std::size_t>();
  });
  module.def("certify", &certify_drawing);
  module.def("certify_promise", &certify_promise);
  module.def("drawing", &drawing_of);
  module.def("generate", &generate_graph);
  module.def("algorithms", [] { return names_of(algorithms()); });
  module.def("families", [] { return names_of(families()); });
}

}  // namespace
}  // namespace ar3d

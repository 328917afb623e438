// The strokes of a projection as SVG and as TikZ.

#include <fmt/format.h>

#include "ar3d/formats/drawings/drawing_exports.h"

namespace ar3d {
std::string drawing_to_svg(const Drawing& drawing, const ExportOptions& view) {
  const Projection picture = project(drawing, view, "svg");
  const EdgeRoles roles = edge_roles(drawing);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\">\n"
      "<defs><radialGradient id=\"ball\" cx=\"35%\" cy=\"30%\" r=\"75%\"><stop offset=\"0\" "
      "stop-color=\"#fff\"/>"
      "<stop offset=\"0.35\" stop-color=\"#777\"/><stop offset=\"1\" "
      "stop-color=\"#111\"/></radialGradient></defs>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g stroke-linecap=\"round\">\n",
      picture.width, picture.height);
  for (const Projection::PaintedItem& item : picture.items) {
    if (item.role < 0) {
      out += fmt::format(
          "<circle class=\"vertex\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" "
          "fill=\"url(#ball)\"{}\n",
          item.from.x, item.from.y, picture.ball * item.scale,
          drawing.names
              ? fmt::format("><title>{}</title></circle>", xml_text((*drawing.names)[item.vertex]))
              : "/>");
      continue;
    }
    const Rgb c = faded(roles.roles[static_cast<std::size_t>(item.role)].second, item.nearness);
    out += fmt::format(
        "<path class=\"role{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#{:02x}{:02x}{:02x}\" "
        "stroke-width=\"{:.1f}\"/>\n",
        item.role, item.from.x, item.from.y, item.to.x, item.to.y, c[0], c[1], c[2],
        picture.stroke * item.scale);
  }
  return out + "</g>\n</svg>\n";
}

std::string drawing_to_tikz(const Drawing& drawing, const ExportOptions& view) {
  const Projection picture = project(drawing, view, "tikz");
  const EdgeRoles roles = edge_roles(drawing);
  constexpr double kPoints = 0.4;  // of one unit of the picture: 900 units are 12.7 cm
  std::string out =
      "% Made by ar3d; \\usepackage{tikz} in the preamble, then \\input this file.\n"
      "\\begin{tikzpicture}[x=1pt, y=-1pt, line cap=round]\n";
  for (std::size_t role = 0; role < roles.roles.size(); ++role) {
    const Rgb c = roles.roles[role].second;
    out += fmt::format("\\definecolor{{ar3drole{}}}{{RGB}}{{{},{},{}}}\n", role, c[0], c[1], c[2]);
  }
  for (const Projection::PaintedItem& item : picture.items) {
    if (item.role < 0) {
      out += fmt::format("\\shade[ball color=black!75] ({:.2f},{:.2f}) circle[radius={:.2f}pt];\n",
                         kPoints * item.from.x, kPoints * item.from.y,
                         kPoints * picture.ball * item.scale);
      continue;
    }
    out += fmt::format(
        "\\draw[ar3drole{}!{:.0f}, line width={:.2f}pt] ({:.2f},{:.2f}) -- ({:.2f},{:.2f});\n",
        item.role, 100 * (0.55 + 0.45 * item.nearness), kPoints * picture.stroke * item.scale,
        kPoints * item.from.x, kPoints * item.from.y, kPoints * item.to.x, kPoints * item.to.y);
  }
  return out + "\\end{tikzpicture}\n";
}

}  // namespace ar3d

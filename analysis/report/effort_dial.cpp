#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "ar3d/analysis/report/figures.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

/// Where one setting stands on one family: medians at one n, as decimal logarithms.
struct Setting {
  std::string options;
  double time = 0, volume = 0;
  std::size_t row = 0;
};

/// One line of the dial.
struct Dial {
  std::string family;
  std::int64_t n = 0;
  std::vector<Setting> settings;
};

using SizesOf = std::map<std::int64_t, const SizeSample*>;
/// The sizes of one algorithm on one family, by options and quantity.
using Measured = std::map<std::string, std::map<Quantity, SizesOf>>;

std::map<std::string, std::map<std::string, Measured>> measured_by_algorithm(
    const StudyAnalysis& analysis) {
  std::map<std::string, std::map<std::string, Measured>> all;
  for (const ScalingEntry& entry : analysis.scaling) {
    if (entry.quantity != Quantity::wall_s && entry.quantity != Quantity::volume) continue;
    SizesOf& sizes =
        all[entry.key.algorithm][family_label(entry.key)][entry.key.options][entry.quantity];
    for (const SizeSample& size : entry.all) {
      if (!size.censored) sizes[size.n] = &size;
    }
  }
  return all;
}

/// The largest n at which every setting has both quantities; 0 if there is none.
std::int64_t common_n(const Measured& measured) {
  std::map<std::int64_t, std::size_t> times_seen;
  for (const auto& [options, quantities] : measured) {
    for (const auto& [quantity, sizes] : quantities) {
      for (const auto& [n, size] : sizes) ++times_seen[n];
    }
  }
  std::int64_t largest = 0;
  for (const auto& [n, times] : times_seen) {
    if (times == 2 * measured.size()) largest = n;
  }
  return largest;
}

std::vector<Dial> dials_of(const std::map<std::string, Measured>& families) {
  std::vector<Dial> dials;
  for (const auto& [family, measured] : families) {
    const std::int64_t n = common_n(measured);
    if (measured.size() < 2 || n == 0) continue;
    Dial dial{family, n, {}};
    for (const auto& [options, quantities] : measured) {
      const SizeSample& time = *quantities.at(Quantity::wall_s).at(n);
      const SizeSample& volume = *quantities.at(Quantity::volume).at(n);
      dial.settings.push_back({options, decimal(median(time.log_values())),
                               decimal(median(volume.log_values())), time.instances.front().row});
    }
    dials.push_back(std::move(dial));
  }
  std::size_t most = 0;  // families with fewer settings would hide the others
  for (const Dial& dial : dials) most = std::max(most, dial.settings.size());
  std::erase_if(dials, [&](const Dial& dial) { return dial.settings.size() < most; });
  return dials;
}

Frame dial_frame(const std::vector<Dial>& dials) {
  Range x, y;
  for (const Dial& dial : dials) {
    for (const Setting& setting : dial.settings) {
      x.include(setting.time);
      y.include(setting.volume);
    }
  }
  return {LogAxis(x.low, x.high, kLeft, kRight),
          LogAxis(y.low, y.high, kBottom, kTop + 28),
          TickStyle::seconds,
          TickStyle::power,
          "drawing time",
          "volume"};
}

/// What differs between the settings of a dial: for "effort=2;window=55" the word "effort=2".
std::string differing_words(const std::string& options, const Dial& dial) {
  std::string words;
  for (std::size_t begin = 0; begin < options.size();) {
    const std::size_t end = std::min(options.find(';', begin), options.size());
    const std::string word = options.substr(begin, end - begin);
    const bool is_common =
        std::all_of(dial.settings.begin(), dial.settings.end(), [&](const Setting& setting) {
          return (";" + setting.options + ";").find(";" + word + ";") != std::string::npos;
        });
    if (!is_common) words += (words.empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return words;
}

/// "effort" if that alone differs in every setting, else empty.
std::string only_name(const Dial& dial) {
  std::string name;
  for (const Setting& setting : dial.settings) {
    const std::string words = differing_words(setting.options, dial);
    const std::string own = words.substr(0, words.find('='));
    if (words.find(' ') != std::string::npos || (!name.empty() && own != name)) return "";
    name = own;
  }
  return name;
}

/// "2" where the effort alone differs, else "effort=2 window=55".
std::string setting_label(const Setting& setting, const Dial& dial) {
  const std::string words = differing_words(setting.options, dial);
  return only_name(dial).empty() ? words : words.substr(words.find('=') + 1);
}

std::string dial_line(const Dial& dial, std::size_t colour, const Frame& frame) {
  std::string line, labels;
  Dots dots;
  for (const Setting& setting : dial.settings) {
    const double x = frame.x.pixel(setting.time), y = frame.y.pixel(setting.volume);
    line += frame.point(setting.time, setting.volume);
    dots.add(x, y, setting.row);
    labels += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>", x, y - 8,
                          escape(setting_label(setting, dial)));
  }
  return fmt::format("<polyline class='median {}' points='{}'><title>{}</title></polyline>",
                     stroke_class(colour), line, escape(dial.family)) +
         "<g class='labels'>" + labels + "</g>" + dots.svg("points big " + stroke_class(colour));
}

std::string dial_note(const std::vector<Dial>& dials) {
  std::string note = only_name(dials.front());
  if (!note.empty()) note += "; ";
  for (std::size_t i = 0; i < dials.size(); ++i) {
    note += fmt::format("{}{}, n = {}", i == 0 ? "" : "; ", dials[i].family, grouped(dials[i].n));
  }
  return note;
}

}  // namespace

std::vector<NamedPlot> effort_dials(const StudyAnalysis& analysis) {
  std::vector<NamedPlot> plots;
  for (const auto& [algorithm, families] : measured_by_algorithm(analysis)) {
    const std::vector<Dial> dials = dials_of(families);
    if (dials.empty()) continue;
    const Frame frame = dial_frame(dials);
    std::string content = axes_svg(frame);
    NamedPlot plot{"effort", algorithm, dial_note(dials), "", {}};
    for (std::size_t i = 0; i < dials.size(); ++i) {
      content += dial_line(dials[i], i, frame);
      plot.legend.push_back({dials[i].family, i});
    }
    const std::string title =
        fmt::format("volume against drawing time of {} by setting", algorithm);
    plot.svg = svg_element(title, kHeight, content);
    plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace ar3d::report

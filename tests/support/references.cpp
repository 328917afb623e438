#include "support/references.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "support/comments.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

namespace fs = std::filesystem;

bool is_page(const std::string& path) { return path.ends_with(".md"); }
bool is_cpp(const std::string& path) { return path.ends_with(".h") || path.ends_with(".cpp"); }

/// What others wrote.
bool is_foreign(const std::string& path) {
  return path.starts_with("formats/drawings/viewer/three/");
}

/// The anchor of a heading or of a link, as GitHub makes it; what is not ASCII is left out.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto u = static_cast<unsigned char>(c);
    if (u < 128 && (std::isalnum(u) != 0 || c == '-' || c == '_')) {
      anchor += static_cast<char>(std::tolower(u));
    } else if (c == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

/// Pages of the past, which may name what is gone.
bool is_history(const std::string& path) { return path == "CHANGELOG.md"; }

/// Names from outside the tree, or built from parts.
bool is_known_outside(const std::string& name) {
  static const std::set<std::string> names = {"OMP_NUM_THREADS", "FIELD_i_NAME",    "member_",
                                              "kConstant",       "perf_event_open", "hdf5.h",
                                              "--sshlogin",      "--return",        "--array"};
  static const std::regex built(
      "fuzz_.*|ar3d_.*_tests|--(gtest|benchmark)_.*|.*_(bound|slack)_[xyz]|slack_[xyz]|std::.*");
  return names.contains(name) || std::regex_match(name, built);
}

class Checker {
 public:
  explicit Checker(const Tree& tree) : tree_(tree) {
    for (const auto& [path, text] : tree.files) {
      if (is_foreign(path)) continue;
      const std::string& code = parts_.emplace(path, parts_of(path, text)).first->second.code;
      each(code, "[A-Za-z_][A-Za-z0-9_]*", [&](const std::smatch& m) { words_.insert(m.str()); });
      if (is_page(path)) collect_definitions(path, text);
      if (path.starts_with("tests/") && is_cpp(path)) collect_tests(code);
      for (std::size_t slash = path.find('/'); slash != std::string::npos;
           slash = path.find('/', slash + 1)) {
        folders_.insert(path.substr(0, slash + 1));
      }
    }
  }

  std::vector<std::string> run() {
    for (const auto& [path, parts] : parts_) {
      if (is_history(path)) continue;
      path_ = path;
      prose_ = parts.comments;
      check_numbers();
      check_private_numbers();
      check_links();
      check_paths();
      check_fences();
      check_spans();
      check_options();
      check_function_tables();
    }
    return std::move(findings_);
  }

 private:
  using Visit = std::function<void(const std::smatch&)>;

  static void each(const std::string& text, const std::string& pattern, const Visit& visit) {
    const std::regex regex(pattern, std::regex::optimize);
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) visit(*at);
  }

  void report(std::ptrdiff_t offset, const std::string& what) {
    const auto line = 1 + std::count(prose_.begin(), prose_.begin() + offset, '\n');
    findings_.push_back(fmt::format("{}:{}: {}", path_, line, what));
  }

  void collect_definitions(const std::string& path, const std::string& text) {
    static const std::map<std::string, std::string> pages = {
        {"1", "docs/theorem1.md"},       {"2", "docs/theorem2.md"},
        {"3", "docs/theorem3.md"},       {"C", "docs/compact.md"},
        {"D", "docs/compact-120.md"},    {"E", "docs/two-bend-109.md"},
        {"G", "docs/theorem3-paper.md"}, {"H", "docs/history.md"},
        {"L", "docs/lower-bounds.md"},   {"P", "docs/theorem2-paper.md"},
        {"V", "docs/verify.md"}};
    each(text, "(?:^|[^`])\\*\\*(Lemma|Rule|Step|Repair) ([0-9CDEGHLPV])\\.([0-9]+)",
         [&](const std::smatch& m) {
           const std::string name = m[1].str() + " " + m[2].str() + "." + m[3].str();
           if (!defined_.insert(name).second)
             findings_.push_back(fmt::format("{}: {} is defined twice", path, name));
           const auto page = pages.find(m[2].str());
           if (page == pages.end() || page->second != path) {
             findings_.push_back(fmt::format("{}: {} belongs into {}", path, name,
                                             page == pages.end() ? "no page" : page->second));
           }
         });
  }

  void collect_tests(const std::string& code) {
    each(code, "TEST(_F|_P)?\\(\\s*(\\w+),\\s*(\\w+)\\)", [&](const std::smatch& m) {
      tests_.insert(m[2].str() + "." + m[3].str());
      tests_.insert(m[2].str() + ".*");
    });
  }

  void check_numbers() {
    const std::string number = "([0-9CDEGHLPV]\\.[0-9]+|[0-9]+)";
    each(prose_,
         "\\b([Ll]emma|[Rr]ule|[Ss]tep|[Ss]tage|[Rr]epair)s?\\s+" + number +
             "((,|\\s+and|\\s+to|\\s+or|–)\\s*" + number + ")*(?![\\w])",
         [&](const std::smatch& m) {
           const std::string kind = m[1].str();
           each(m.str(), "[0-9CDEGHLPV]\\.[0-9]+|[0-9]+", [&](const std::smatch& one) {
             const std::string name = kind + " " + one.str();
             if (one.str().find('.') == std::string::npos || kind == "stage" || kind == "Stage") {
               report(m.position(), name + " has no page: write Lemma, Rule or Step and X.N");
             } else if (!defined_.contains(name)) {
               report(m.position(), name + " is not defined in bold in any page");
             }
           });
         });
  }

  /// Numbers of notes that nobody has who has the tree and the paper.
  void check_private_numbers() {
    each(prose_, "\\bamendments?\\s+[A-Z]?[0-9]|\\bfinding\\s+[0-9]|\\bsections?\\s+[0-9]+(?!\\.)",
         [&](const std::smatch& m) { report(m.position(), m.str() + " is nothing of this tree"); });
    if (is_page(path_)) return;
    each(prose_, "\\([^()\\n]*\\b[RA][0-9]{1,2}\\b[^()]*\\)|\\([0-9]\\.[0-9](\\.[0-9])?[,;)]",
         [&](const std::smatch& m) { report(m.position(), m.str() + " is nothing of this tree"); });
  }

  void check_links() {
    if (!is_page(path_)) return;
    each(prose_, "\\]\\(([^)#\\s]*)(?:#([^)\\s]*))?\\)", [&](const std::smatch& m) {
      const std::string target = m[1].str();
      if (target.find("://") != std::string::npos) return;
      const std::string path =
          target.empty() ? path_
                         : (fs::path(path_).parent_path() / target).lexically_normal().string();
      if (!exists(path)) {
        report(m.position(), "the link to " + target + " leads nowhere");
      } else if (m[2].length() > 0 && is_page(path) && !has_heading(path, m[2].str())) {
        report(m.position(), fmt::format("{} has no heading #{}", path, m[2].str()));
      }
    });
  }

  bool has_heading(const std::string& page, const std::string& anchor) const {
    bool found = false;
    each(tree_.files.at(page), "(?:^|\\n)#+ +([^\\n]*)", [&](const std::smatch& m) {
      found = found || anchor_of(m[1].str()) == anchor_of(anchor);
    });
    return found;
  }

  /// Paths from the root, in backticks or not.
  void check_paths() {
    each(
        prose_,
        "(^|[\\s(`\"])((algorithms|analysis|apps|base|bench|cmake|docs|examples|formats|generators|"
        "model|"
        "python|records|results|store|studies|tests|tools|verify|viewer)/[\\w./-]*\\w\\."
        "(h|cpp|md|toml|txt|cmake|svg|csv|h5|py|mjs|js|css|sh))(?![\\w*<{])",
        [&](const std::smatch& m) {
          static const std::regex placeholder(".*[A-Z]{3}.*\\.(csv|h5)");
          const std::string path = m[2].str();
          if (prose_.substr(0, static_cast<std::size_t>(m.position(2))).ends_with("```cpp\n// "))
            return;  // the file that a page shows how to write
          if (!std::regex_match(path, placeholder) && !exists(path))
            report(m.position(), path + " does not exist");
        });
  }

  bool exists(const std::string& path) const {
    return tree_.files.contains(path) || folders_.contains(path) || folders_.contains(path + "/") ||
           path == "." || path.empty();
  }

  /// A file named by the last parts of its path.
  bool exists_somewhere(const std::string& path) const {
    return exists(path) || std::ranges::any_of(tree_.files, [&](const auto& file) {
             return file.first.ends_with("/" + path);
           });
  }

  /// Fenced blocks hold commands; they are blanked for the checks of spans.
  void check_fences() {
    if (!is_page(path_)) return;
    each(prose_, "(^|\\n)```[^\\n]*\\n([^]*?)```", [&](const std::smatch& m) {
      std::istringstream lines(m[2].str());
      for (std::string line; std::getline(lines, line);) check_command(line, m.position());
    });
    prose_ = std::regex_replace(prose_, std::regex("^```|\\n```"), "\n\x01");
    bool fenced = false;
    for (char& c : prose_) {
      if (c == '\x01') {
        fenced = !fenced;
        c = ' ';
      }
      if (fenced && c != '\n') c = ' ';
    }
  }

  void check_spans() {
    each(prose_, "`([^`]+)`", [&](const std::smatch& m) {
      std::string span = std::regex_replace(m[1].str(), std::regex("\\s+"), " ");
      if (span.size() < 200) check_span(span, m.position());
    });
  }

  void check_span(const std::string& span, std::ptrdiff_t at) {
    if (is_known_outside(span) || span.starts_with("build/")) return;
    static const std::regex path("[\\w.-]+(/[\\w.-]+)*\\.(h|cpp|md|cmake|svg)|(\\w+/)+");
    static const std::regex test("[A-Z][A-Za-z0-9]*\\.(\\*|[A-Z]\\w*)");
    static const std::regex option("--[a-z][a-z-]+");
    static const std::regex name("[A-Za-z_]\\w*(::[A-Za-z_]\\w*)*(\\(.*\\))?");
    static const std::regex marked(".*[a-z]_.*|.*::.*|.*\\)|[A-Z]?[a-z0-9]+[A-Z].*");
    if (std::regex_match(span, path)) {
      const bool at_root = span.back() == '/';
      if (at_root ? !exists_folder(span) : !exists_somewhere(span))
        report(at, span + " does not exist");
    } else if (std::regex_match(span, test)) {
      if (!tests_.contains(span)) report(at, "no test " + span);
    } else if (std::regex_match(span, option)) {
      if (!has_option(span)) report(at, "no program has an option " + span);
    } else if (std::regex_match(span, name) && std::regex_match(span, marked)) {
      check_name(span, at);
    } else {
      check_command(span, at);
    }
  }

  bool exists_folder(const std::string& span) const {
    return std::ranges::any_of(folders_, [&](const std::string& folder) {
      return folder == span || folder.ends_with("/" + span);
    });
  }

  void check_name(const std::string& span, std::ptrdiff_t at) {
    each(span.substr(0, span.find('(')), "\\w+", [&](const std::smatch& part) {
      if (!words_.contains(part.str()))
        report(at, fmt::format("the code has no {} ({})", part.str(), span));
    });
  }

  bool has_option(const std::string& option) const {
    const std::regex whole(option + "(?![\\w-])");
    return std::ranges::any_of(
               tree_.help,
               [&](const auto& verb) { return std::regex_search(verb.second, whole); }) ||
           std::ranges::any_of(parts_, [&](const auto& file) {
             return std::regex_search(file.second.code, whole);
           });
  }

  /// Options in the prose, without backticks. What fences and commands hold is looked at there.
  void check_options() {
    each(prose_, "(?:^|[\\s(\"])(--[a-z][a-z_-]*[a-z])", [&](const std::smatch& m) {
      if (!is_known_outside(m[1].str()) && !has_option(m[1].str()))
        report(m.position(1), "no program has an option " + m[1].str());
    });
  }

  /// What stands in a column headed "function" of a table.
  void check_function_tables() {
    if (!is_page(path_)) return;
    std::ptrdiff_t offset = 0;
    std::size_t column = 0;  // of the table at hand; 0: none
    std::istringstream lines(prose_);
    for (std::string line; std::getline(lines, line);
         offset += static_cast<std::ptrdiff_t>(line.size()) + 1) {
      std::vector<std::string> cells;
      std::istringstream row(line);
      for (std::string cell; line.starts_with("|") && std::getline(row, cell, '|');)
        cells.push_back(cell);
      if (cells.empty()) column = 0;
      for (std::size_t i = 1; i < cells.size(); ++i) {
        if (cells[i] == " function ") column = i;
      }
      if (column == 0 || column >= cells.size()) continue;
      each(cells[column], "`([A-Za-z_:]+)`",
           [&](const std::smatch& m) { check_name(m[1].str(), offset); });
    }
  }

  /// Every call of the program in a line: verb, sub-verb and options.
  void check_command(const std::string& line, std::ptrdiff_t at) {
    each(line, "(^ *|[|;&$] *|[A-Z_]+=\\S+ +|mpirun -n \\S+ +)(\\./)?ar3d +((?:[^|;&>#]|\\\\\\|)+)",
         [&](const std::smatch& m) {
           std::istringstream stream(m[3].str());
           std::vector<std::string> words(std::istream_iterator<std::string>(stream), {});
           if (!words.empty()) check_call(words, at);
         });
  }

  void check_call(const std::vector<std::string>& words, std::ptrdiff_t at) {
    if (!std::islower(static_cast<unsigned char>(words[0][0]))) return;  // VERB, --version, …
    const std::string verb = strip(words[0]);
    if (!tree_.help.contains(verb)) return report(at, "the program has no verb " + verb);
    std::vector<std::string> verbs{verb};
    if (tree_.help.at(verb).find("Subcommands:") != std::string::npos && words.size() > 1 &&
        std::islower(static_cast<unsigned char>(words[1][0])) != 0) {
      verbs.clear();
      each(strip(words[1]), "[\\w-]+",
           [&](const std::smatch& m) { verbs.push_back(verb + " " + m.str()); });
    }
    for (const std::string& name : verbs) {
      if (is_hidden(name)) continue;
      if (!tree_.help.contains(name)) return report(at, "the program has no verb " + name);
      for (const std::string& word : words) check_option_of(name, word, at);
    }
  }

  /// Verbs that programs use, not people, are in no help.
  bool is_hidden(const std::string& verb) const {
    const std::string literal = "\"" + verb.substr(verb.rfind(' ') + 1) + "\"";
    return verb.find('-') != std::string::npos &&
           std::ranges::any_of(tree_.files, [&](const auto& file) {
             return file.first.starts_with("bench/") &&
                    file.second.find(literal) != std::string::npos;
           });
  }

  void check_option_of(const std::string& verb, const std::string& word, std::ptrdiff_t at) {
    std::smatch m;
    if (!std::regex_match(word, m, std::regex("\\[?(--[a-z][a-z-]*)(=.*|[\\],.…].*)?"))) return;
    const std::regex whole(m[1].str() + "(?![a-z-])");
    if (m[1].str() != "--help" && !std::regex_search(tree_.help.at(verb), whole))
      report(at, fmt::format("ar3d {} has no option {}", verb, m[1].str()));
  }

  static std::string strip(std::string word) {
    while (!word.empty() && std::string("],.:`").find(word.back()) != std::string::npos)
      word.pop_back();
    return word;
  }

  const Tree& tree_;
  std::map<std::string, TextParts> parts_;
  std::set<std::string> words_;    // of all code
  std::set<std::string> folders_;  // with a '/' at the end
  std::set<std::string> tests_;    // Suite.Name and Suite.*
  std::set<std::string> defined_;  // numbers with their kinds
  std::string path_;               // of the file at hand
  std::string prose_;
  std::vector<std::string> findings_;
};

}  // namespace

std::vector<std::string> dangling_references(const Tree& tree) { return Checker(tree).run(); }

}  // namespace ar3d::testing

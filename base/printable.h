#pragma once

#include <string>
#include <string_view>

namespace ar3d {

/// Returns foreign text (names of files, words of an input, messages that hold them) as it may
/// stand on one line of a terminal or a log: printable UTF-8 stays; control characters, line ends,
/// what turns the direction of text, and bytes that are no UTF-8 become "\xNN", byte by byte. So no
/// escape sequence reaches a terminal, and no text looks like another line. O(length) time.
std::string printable(std::string_view text);

/// Returns the text with every byte that is no part of UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// Returns valid UTF-8 on one line: control characters (escape sequences of terminals too) become
/// spaces.
std::string one_line(std::string_view text);

/// Makes several lines safe for a terminal as printable() does; ends of lines and tabulators stay.
std::string printable_lines(std::string_view text);

/// Gives true if printable() changes nothing, as columns of text hold it. O(length); ASCII is fast.
bool all_printable(std::string_view text);

/// Returns the word as a POSIX shell reads it back: in quotes unless it is plain.
std::string shell_word(std::string_view word);

}  // namespace ar3d

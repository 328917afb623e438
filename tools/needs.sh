# Sourced by tools, first of all. needs TOOL COMMAND=PACKAGE...: ends the tool with one line that names the Debian packages of the
# commands that are not there. Only builtins of bash.
needs() {
  local tool=$1 one missing=()
  shift
  for one; do command -v "${one%%=*}" >/dev/null || missing+=("${one#*=}"); done
  [ ${#missing[@]} -eq 0 ] && return
  echo "$tool: it needs Debian's ${missing[*]}: apt install ${missing[*]}" >&2
  exit 2
}

# Completion of ar3d for bash: verbs, options, algorithms, families, formats and studies, asked of the program itself.
_ar3d() {
  local word=${COMP_WORDS[COMP_CWORD]} last=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]} verbs=() offered="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == [a-z]* ]] || break
    verbs+=("${COMP_WORDS[i]}")
    [[ ${COMP_WORDS[i]} == study ]] || break
  done
  case $last in
    --algorithm) offered=$("$program" list algorithms 2>/dev/null | sed -n 's/^\([a-z][a-z0-9-]*\): .*/\1/p') ;;
    --format) offered=$("$program" "${verbs[@]}" --help 2>/dev/null | sed -n 's/^  \([a-z0-9]*\)  *\.[a-z].*/\1/p') ;;
    generate) offered=$("$program" list families 2>/dev/null | sed -n 's/^\([a-z][a-z0-9-]*\): .*/\1/p') ;;
    run | plan) offered=$("$program" list studies 2>/dev/null | sed -n 's/^\([a-z][a-z0-9-]*\): .*/\1/p') ;;
    *)
      local help
      help=$("$program" "${verbs[@]}" --help 2>/dev/null)
      if [[ $word == -* ]]; then
        offered=$(grep -oE '^  (-[a-zA-Z],)?--[a-z-]+' <<<"$help" | sed 's/.*--/--/')
      else
        offered=$(sed -n '/^Subcommands:/,/^[A-Z].*:$/s/^  \([a-z][a-z-]*\)  *.*/\1/p' <<<"$help")
      fi
      ;;
  esac
  COMPREPLY=($(compgen -W "$offered" -- "$word"))
}
complete -o default -F _ar3d ar3d ./ar3d

# Completion for bash: commands, then the options that the command's --help names, and files.
_plumb() {
  local word=${COMP_WORDS[COMP_CWORD]}
  if ((COMP_CWORD == 1)) || { ((COMP_CWORD == 2)) && [[ ${COMP_WORDS[1]} == help ]]; }; then
    mapfile -t COMPREPLY < <(compgen -W "help $("${COMP_WORDS[0]}" --commands 2>/dev/null | cut -f 1)" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" "${COMP_WORDS[1]}" --help 2>/dev/null | grep -oE '^  .*' | grep -oE -- '--[a-z-]+' | sort -u)" -- "$word")
  fi
}
complete -o default -F _plumb plumb

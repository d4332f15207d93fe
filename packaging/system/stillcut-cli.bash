# Completion of stillcut-cli for bash. Commands, options and the words that an option takes come from the program's own
# help, so that they cannot disagree.
_stillcut_cli_help() { "${COMP_WORDS[0]}" "$@" --help 2>/dev/null; }

_stillcut_cli() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command="" word help choices
  COMPREPLY=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in -*) ;; *) command=$word && break ;; esac
  done
  if [ -z "$command" ]; then
    help=$(_stillcut_cli_help)
    word=$(sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p; s/^ *\(-h,\)\{0,1\}\(--[a-z-]*\).*/\2/p' <<<"$help")
    mapfile -t COMPREPLY < <(compgen -W "$word" -- "$cur")
    return
  fi
  help=$(_stillcut_cli_help "$command")
  case $cur in
  -*)
    mapfile -t COMPREPLY < <(compgen -W "$(sed -n 's/^ *\(-[a-z],\)\{0,1\}\(--[a-z-]*\).*/\2/p' <<<"$help")" -- "$cur")
    return
    ;;
  esac
  case $prev in
  --set)
    mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" parameters | sed -n 's/^\([a-z].*\) = .*/\1=/p')" -- "$cur")
    compopt -o nospace 2>/dev/null
    return
    ;;
  --*)
    # An option that takes one of some words says so: --mode TEXT:{off,advise,auto}
    choices=$(sed -n "s/^ *$prev [^{]*{\([^}]*\)}.*/\1/p" <<<"$help" | tr ',' ' ')
    if [ -n "$choices" ]; then
      mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$cur")
      return
    fi
    ;;
  esac
  if [ "$command" = reproduce ] && [ "$prev" != --out ]; then
    mapfile -t COMPREPLY < <(compgen -W "all $("${COMP_WORDS[0]}" reproduce --list | sed 's/ .*//')" -- "$cur")
    return
  fi
  mapfile -t COMPREPLY < <(compgen -f -- "$cur")
  compopt -o filenames 2>/dev/null
}
complete -F _stillcut_cli stillcut-cli

# Completion for bash of the program place_memory; the shell reads it by: . place_memory.bash
_place_memory() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  local commands="list show learn recognize plan go export merge history undo stats check twins changes"
  local options="--store --node --params --json --png --from --label --scan --count --help"
  case $before in
    --store | -s | --from | --params | --png | merge)
      mapfile -t COMPREPLY < <(compgen -f -- "$word")
      compopt -o filenames 2>/dev/null
      return
      ;;
    export)
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      return
      ;;
    --node | -n)
      mapfile -t COMPREPLY < <(compgen -W "$(rosnode list 2>/dev/null)" -- "$word")
      return
      ;;
  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word")
  fi
}
complete -F _place_memory place_memory

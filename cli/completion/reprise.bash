# bash completion of reprise. A test holds the words against `reprise --help`.
_reprise() {
  local commands="optimize emit validate analyze check play report devices"
  local common="--help --version --quiet --error-format --device"
  local word="${COMP_WORDS[COMP_CWORD]}" previous="${COMP_WORDS[COMP_CWORD - 1]}" command="" options="" each
  for each in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    if [[ " $commands " == *" $each "* ]]; then command="$each"; break; fi
  done
  case "$previous" in
    --metric) COMPREPLY=($(compgen -W "rms mean p95 largest relative_rms ssim flip over8 flicker tile_rms tile_flip tile_flicker blocks" -- "$word")); return ;;
    --quality) COMPREPLY=($(compgen -W "imperceptible good draft" -- "$word")); return ;;
    --on-stale) COMPREPLY=($(compgen -W "fail original" -- "$word")); return ;;
    --error-format) COMPREPLY=($(compgen -W "text json" -- "$word")); return ;;
  esac
  case "$command" in
    "") COMPREPLY=($(compgen -W "$commands $common" -- "$word")); return ;;
    optimize) options="--quality --max --max-error --metric --min-gain --budget --output -o" ;;
    emit) options="--choice --output -o --header --name --on-stale --quality --max --max-error --metric --verify -M -MD -MF -MT" ;;
    validate) options="--choice --cost-tolerance --output -o" ;;
    analyze) options="--json --all --annotate -I -D -std --entry-point -MD -MF" ;;
    check) options="--json --jobs -j --seed --candidates --strategy --timeout -I -D --entry-point" ;;
    play) options="--scenario --session --frames --period --original --png --hashes" ;;
    devices) options="--json" ;;
  esac
  if [[ "$word" == -* ]]; then COMPREPLY=($(compgen -W "$options $common" -- "$word")); else COMPREPLY=($(compgen -f -- "$word")); fi
}
complete -o filenames -F _reprise reprise

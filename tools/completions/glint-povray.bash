# bash completion for glint-povray, printed by `glint completion bash --program glint-povray`
_glint-povray() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} start='' endings='pov ini' file ending
    COMPREPLY=()
    case $before in
        *) ;;
    esac
    case $word in
        +I*|+O*|+L*) start=${word:0:2} ;;
        [-+]*)
            [[ $word == +* ]] && compopt -o nospace 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -W '+I +O +W +H +FN +FT +FP +FE -F +A -A +R +Q +WT +UA +L +K -V -D -P -C -J +X +AM +MB --help --version' -- "$word")
            return ;;
    esac
    compopt -o filenames 2>/dev/null
    while IFS= read -r file; do
        if [[ -d $file || -z $endings ]]; then
            COMPREPLY+=("$start$file")
            continue
        fi
        for ending in $endings; do
            [[ $file == *".$ending" ]] && COMPREPLY+=("$start$file")
        done
    done < <(compgen -f -- "${word#"$start"}")
}
complete -F _glint-povray glint-povray

#compdef glint-povray
# zsh completion for glint-povray, printed by `glint completion zsh --program glint-povray`
_glint-povray() {
    case $words[CURRENT-1] in
    esac
    case $PREFIX in
        +I*|+O*|+L*) compset -P '[+]?'; _files ;;
        +*) compadd -S '' -- +I +O +W +H +FN +FT +FP +FE -F +A -A +R +Q +WT +UA +L +K -V -D -P -C -J +X +AM +MB --help --version ;;
        -*) compadd -- +I +O +W +H +FN +FT +FP +FE -F +A -A +R +Q +WT +UA +L +K -V -D -P -C -J +X +AM +MB --help --version ;;
        *) _files -g "*.(pov|ini)" ;;
    esac
}
if [[ $funcstack[1] == _glint-povray ]]; then
    _glint-povray "$@"
else
    compdef _glint-povray glint-povray
fi

#compdef glint-tachyon
# zsh completion for glint-tachyon, printed by `glint completion zsh --program glint-tachyon`
_glint-tachyon() {
    case $words[CURRENT-1] in
        -format) compadd -- TARGA PNG PPM PPM48; return ;;
        -o|-camfile) _files; return ;;
        -res|-aasamples|-numthreads|-raydepth|-trans_max_surfaces|-rescale_lights|-add_skylight|-auto_skylight|-skylight_samples|-boundthresh|-gamma|-cropoutput|-crop|-normalfixup|-spaceballport) return ;;
    esac
    case $PREFIX in
        +*) compadd -S '' -- -o -format -res -aasamples -numthreads -raydepth -fullshade -mediumshade -lowshade -lowestshade -shade_blinn -shade_phong -shade_nullphong -shade_blinn_fast -trans_orig -trans_vmd -trans_raster3d -trans_max_surfaces -shadow_filter_on -shadow_filter_off -fog_normal -fog_radial -fog_vmd -rescale_lights -add_skylight -auto_skylight -skylight_samples -nosave -clamp -nobounding -boundthresh +V -V -normalize -gamma -cropoutput -cropoutputauto -crop -camfile -normalfixup -spaceball -spaceballport -help -version ;;
        -*) compadd -- -o -format -res -aasamples -numthreads -raydepth -fullshade -mediumshade -lowshade -lowestshade -shade_blinn -shade_phong -shade_nullphong -shade_blinn_fast -trans_orig -trans_vmd -trans_raster3d -trans_max_surfaces -shadow_filter_on -shadow_filter_off -fog_normal -fog_radial -fog_vmd -rescale_lights -add_skylight -auto_skylight -skylight_samples -nosave -clamp -nobounding -boundthresh +V -V -normalize -gamma -cropoutput -cropoutputauto -crop -camfile -normalfixup -spaceball -spaceballport -help -version ;;
        *) _files -g "*.(dat)" ;;
    esac
}
if [[ $funcstack[1] == _glint-tachyon ]]; then
    _glint-tachyon "$@"
else
    compdef _glint-tachyon glint-tachyon
fi

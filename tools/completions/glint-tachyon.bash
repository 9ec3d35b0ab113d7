# bash completion for glint-tachyon, printed by `glint completion bash --program glint-tachyon`
_glint-tachyon() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} start='' endings='dat' file ending
    COMPREPLY=()
    case $before in
        -format) mapfile -t COMPREPLY < <(compgen -W 'TARGA PNG PPM PPM48' -- "$word"); return ;;
        -o|-camfile) endings='' ;;
        -res|-aasamples|-numthreads|-raydepth|-trans_max_surfaces|-rescale_lights|-add_skylight|-auto_skylight|-skylight_samples|-boundthresh|-gamma|-cropoutput|-crop|-normalfixup|-spaceballport) return ;;
        *) ;;
    esac
    case $word in
        [-+]*)
            [[ $word == +* ]] && compopt -o nospace 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -W '-o -format -res -aasamples -numthreads -raydepth -fullshade -mediumshade -lowshade -lowestshade -shade_blinn -shade_phong -shade_nullphong -shade_blinn_fast -trans_orig -trans_vmd -trans_raster3d -trans_max_surfaces -shadow_filter_on -shadow_filter_off -fog_normal -fog_radial -fog_vmd -rescale_lights -add_skylight -auto_skylight -skylight_samples -nosave -clamp -nobounding -boundthresh +V -V -normalize -gamma -cropoutput -cropoutputauto -crop -camfile -normalfixup -spaceball -spaceballport -help -version' -- "$word")
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
complete -F _glint-tachyon glint-tachyon

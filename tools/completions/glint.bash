# bash completion for glint, printed by `glint completion bash`
_glint() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
    local options='' words='' kind=''
    COMPREPLY=()
    if [[ $COMP_CWORD == 1 ]]; then
        mapfile -t COMPREPLY < <(compgen -W 'render info convert check explain compare versus grade join completion help version --help --version' -- "$word")
        return
    fi
    case $command in
        render)
            options='-h --help --scene --include-path --max-memory --format --profile --convention -o --output -s --size --shading --no-shadows --reflections --aa --seed --alpha --aov --crop --transfer --bits -t --threads --isa --resume --part --stats --strict --show -q --quiet'
            [[ $word == -* ]] || case $before in
                --scene) return ;;
                --include-path) return ;;
                --max-memory) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                -o|--output) kind=file ;;
                -s|--size) return ;;
                --shading) words='phong blinn-phong diffuse color normals' ;;
                --reflections) return ;;
                --aa) words='N adaptive:N[:T]' ;;
                --seed) return ;;
                --aov) words='all background ambient diffuse specular reflection transmission emission sky fog normal depth position albedo shadow occlusion object material alpha' ;;
                --crop) return ;;
                --transfer) words='none srgb' ;;
                --bits) words='8 16' ;;
                -t|--threads) return ;;
                --isa) words=$(glint info --isa 2>/dev/null) ;;
                --part) return ;;
                --stats) kind=file ;;
                *) kind=scene ;;
            esac ;;
        info)
            options='-h --help --scene --include-path --max-memory --format --profile --convention --json --isa'
            [[ $word == -* ]] || case $before in
                --scene) return ;;
                --include-path) return ;;
                --max-memory) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                *) kind=scene ;;
            esac ;;
        convert)
            options='-h --help --scene --include-path --max-memory --format --profile --convention -o --output -q --quiet'
            [[ $word == -* ]] || case $before in
                --scene) return ;;
                --include-path) return ;;
                --max-memory) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                -o|--output) kind=file ;;
                *) kind=scene ;;
            esac ;;
        check)
            options='-h --help --scene --include-path --max-memory --format --profile --convention -s --size --shading --no-shadows --reflections --aa --seed -t --threads --strict --json -q --quiet'
            [[ $word == -* ]] || case $before in
                --scene) return ;;
                --include-path) return ;;
                --max-memory) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                -s|--size) return ;;
                --shading) words='phong blinn-phong diffuse color normals' ;;
                --reflections) return ;;
                --aa) words='N adaptive:N[:T]' ;;
                --seed) return ;;
                -t|--threads) return ;;
                *) kind=scene ;;
            esac ;;
        explain)
            options='-h --help --scene --include-path --max-memory --format --profile --convention -p --pixel --sample --fold --all --as --origin --why-not --overlay -s --size --shading --no-shadows --reflections --aa --seed --alpha --transfer --bits --isa'
            [[ $word == -* ]] || case $before in
                --scene) return ;;
                --include-path) return ;;
                --max-memory) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                -p|--pixel) return ;;
                --sample) return ;;
                --fold) return ;;
                --as) words='text json printrays' ;;
                --origin) words='top-left bottom-left' ;;
                --why-not) return ;;
                --overlay) kind=file ;;
                -s|--size) return ;;
                --shading) words='phong blinn-phong diffuse color normals' ;;
                --reflections) return ;;
                --aa) words='N adaptive:N[:T]' ;;
                --seed) return ;;
                --transfer) words='none srgb' ;;
                --bits) words='8 16' ;;
                --isa) words=$(glint info --isa 2>/dev/null) ;;
                *) kind=scene ;;
            esac ;;
        compare)
            options='-h --help --within --fail-percent --hard-fail --diff --vary --scene --scene-name --include-path --format --profile --convention -s --size --shading --no-shadows --reflections --aa --seed -t --threads --max-memory --no-causes --json -q --quiet'
            [[ $word == -* ]] || case $before in
                --within) return ;;
                --fail-percent) return ;;
                --hard-fail) return ;;
                --diff) kind=file ;;
                --vary) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                --scene) kind=scene ;;
                --scene-name) return ;;
                --include-path) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                -s|--size) return ;;
                --shading) words='phong blinn-phong diffuse color normals' ;;
                --reflections) return ;;
                --aa) words='N adaptive:N[:T]' ;;
                --seed) return ;;
                -t|--threads) return ;;
                --max-memory) return ;;
                *) kind=file ;;
            esac ;;
        versus)
            options='-h --help --scene --include-path --max-memory --format --profile --convention --a --b --match-exponents -o --output --json -s --size --shading --no-shadows --reflections --aa --seed'
            [[ $word == -* ]] || case $before in
                --scene) return ;;
                --include-path) return ;;
                --max-memory) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                --a) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed= profile='; compopt -o nospace 2>/dev/null ;;
                --b) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed= profile='; compopt -o nospace 2>/dev/null ;;
                -o|--output) kind=file ;;
                -s|--size) return ;;
                --shading) words='phong blinn-phong diffuse color normals' ;;
                --reflections) return ;;
                --aa) words='N adaptive:N[:T]' ;;
                --seed) return ;;
                *) kind=scene ;;
            esac ;;
        grade)
            options='-h --help --reference --scene --scene-name --include-path --format --profile --convention -s --size --shading --no-shadows --reflections --aa --seed --max-memory --rubric --csv --json --gradescope --prairielearn --pictures --hide-causes --visibility --summary --sheet -t --threads -q --quiet'
            [[ $word == -* ]] || case $before in
                --reference) kind=file ;;
                --scene) kind=scene ;;
                --scene-name) return ;;
                --include-path) return ;;
                --format) words='cgfs epfl csc473 povray nff tachyon glint' ;;
                --profile) words='cgfs epfl lecture5 light csc473 povray nff tachyon glint' kind=file ;;
                --convention) words='pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed='; compopt -o nospace 2>/dev/null ;;
                -s|--size) return ;;
                --shading) words='phong blinn-phong diffuse color normals' ;;
                --reflections) return ;;
                --aa) words='N adaptive:N[:T]' ;;
                --seed) return ;;
                --max-memory) return ;;
                --rubric) kind=file ;;
                --csv) kind=file ;;
                --json) kind=file ;;
                --gradescope) kind=file ;;
                --prairielearn) kind=file ;;
                --visibility) return ;;
                --summary) kind=file ;;
                --sheet) kind=file ;;
                -t|--threads) return ;;
                *) kind=folder ;;
            esac ;;
        join)
            options='-h --help -o --output --transfer --bits --partial -q --quiet'
            [[ $word == -* ]] || case $before in
                -o|--output) kind=file ;;
                --transfer) words='none srgb' ;;
                --bits) words='8 16' ;;
                *) kind=file ;;
            esac ;;
        completion)
            options='-h --help --program'
            [[ $word == -* ]] || case $before in
                --program) words='glint glint-povray glint-tachyon' ;;
                *) words='bash zsh fish' ;;
            esac ;;
        help)
            options='-h --help'
            [[ $word == -* ]] || case $before in
                *) words='render info convert check explain compare versus grade join completion help version' ;;
            esac ;;
        version)
            options='-h --help'
            [[ $word == -* ]] || case $before in
                *) return ;;
            esac ;;
    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
        return
    fi
    [[ -n $words ]] && mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    [[ -z $kind ]] && return
    local file ending
    compopt -o filenames 2>/dev/null
    while IFS= read -r file; do
        if [[ -d $file || $kind == file ]]; then
            COMPREPLY+=("$file")
        elif [[ $kind == scene ]]; then
            for ending in .cgfs .json .js .pov .nff .dat .glint; do
                [[ $file == *"$ending" ]] && COMPREPLY+=("$file")
            done
        fi
    done < <(compgen -f -- "$word")
}
complete -F _glint glint

#compdef glint
# zsh completion for glint, printed by `glint completion zsh`
_glint() {
    if (( CURRENT == 2 )); then
        local -a commands=(
            'render:Render a scene'
            'info:Print a scene'\''s contents and the conventions in force'
            'convert:Convert a scene of any format to .glint; its picture stays the same, bit for bit'
            'check:List a scene'\''s likely mistakes, each with its line and remedy'
            'explain:Explain the color of a pixel'
            'compare:Compare a picture with a reference and explain the difference'
            'versus:Render a scene with two sets of conventions, and explain the pixel that differs most'
            'grade:Compare every picture of a folder with a reference, or with a rubric'\''s parts'
            'join:Make a picture of the parts that render --part wrote'
            'completion:Print a completion script for the shell'
            'help:Print the help of a command, like its --help'
            'version:Print the version, like --version'
        )
        _describe -t commands command commands
        [[ $PREFIX == -* ]] && compadd -- --help --version
        return
    fi
    local curcontext=$curcontext
    shift words
    (( CURRENT-- ))
    case $words[1] in
        render)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:SCENE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--max-memory[The most memory that reading the scene may take: 500M, 4G (default: 2 GiB and 256 times the length of its files)]:SIZE: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '(-o --output)'{-o,--output}'[The picture: .png, .ppm, .tga or .exr]:OUT:_files' \
                '(-s --size)'{-s,--size}'[Size in pixels]:WxH: ' \
                '--shading[How surfaces are shaded]:phong|blinn-phong|diffuse|color|normals:(phong blinn-phong diffuse color normals)' \
                '--no-shadows[No shadows: every light reaches every surface]' \
                '--reflections[Largest number of successive reflections]:N: ' \
                '--aa[N x N samples per pixel]:N|adaptive\:N[\:T]:(N adaptive:N[:T])' \
                '--seed[Number of another picture of everything that is sampled]:N: ' \
                '--alpha[The background is transparent: PNG and OpenEXR have an alpha channel]' \
                '--aov[Also write these layers, separated by commas: background, ambient, diffuse, specular, reflection, transmission, emission, sky, fog, normal, depth, position, albedo, shadow, occlusion, object, material and alpha]:LAYERS:(all background ambient diffuse specular reflection transmission emission sky fog normal depth position albedo shadow occlusion object material alpha)' \
                '--crop[Render only this part of the picture]:WxH+X+Y: ' \
                '--transfer[none: the numbers as computed]:none|srgb:(none srgb)' \
                '--bits[Bits per channel of PNG and PPM: 8 (default) or 16]:8|16:(8 16)' \
                '(-t --threads)'{-t,--threads}'[Number of threads]:N: ' \
                '--isa[Instruction set (`glint info --isa` lists them)]:NAME:{compadd -- $(glint info --isa 2>/dev/null)}' \
                '--resume[Keep finished tiles in OUT.journal, and go on with it if it is there]' \
                '--part[Render only every Nth tile, beginning with the Kth, to OUT.tiles]:K/N: ' \
                '--stats[Write times, rays and memory as JSON]:FILE.json:_files' \
                '--strict[Treat warnings as errors: exit code 1, and no picture is written]' \
                '--show[Also show the picture in the terminal, in 24-bit colors]' \
                '(-q --quiet)'{-q,--quiet}'[Print only errors]' ;;
        info)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:SCENE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--max-memory[The most memory that reading the scene may take: 500M, 4G (default: 2 GiB and 256 times the length of its files)]:SIZE: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '--json[Print JSON]' \
                '--isa[List the instruction sets of this machine, the best first]' ;;
        convert)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:SCENE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--max-memory[The most memory that reading the scene may take: 500M, 4G (default: 2 GiB and 256 times the length of its files)]:SIZE: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '(-o --output)'{-o,--output}'[The output file: a name that ends in .glint]:OUT:_files' \
                '(-q --quiet)'{-q,--quiet}'[Print only errors]' ;;
        check)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:SCENE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--max-memory[The most memory that reading the scene may take: 500M, 4G (default: 2 GiB and 256 times the length of its files)]:SIZE: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '(-s --size)'{-s,--size}'[Size in pixels]:WxH: ' \
                '--shading[How surfaces are shaded]:phong|blinn-phong|diffuse|color|normals:(phong blinn-phong diffuse color normals)' \
                '--no-shadows[No shadows: every light reaches every surface]' \
                '--reflections[Largest number of successive reflections]:N: ' \
                '--aa[N x N samples per pixel]:N|adaptive\:N[\:T]:(N adaptive:N[:T])' \
                '--seed[Number of another picture of everything that is sampled]:N: ' \
                '(-t --threads)'{-t,--threads}'[Number of threads]:N: ' \
                '--strict[Exit code 1 if there is any finding or warning]' \
                '--json[Print the findings as a JSON array]' \
                '(-q --quiet)'{-q,--quiet}'[No progress]' ;;
        explain)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:SCENE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--max-memory[The most memory that reading the scene may take: 500M, 4G (default: 2 GiB and 256 times the length of its files)]:SIZE: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '(-p --pixel)'{-p,--pixel}'[The pixel, counted from 0 at the top left]:X,Y: ' \
                '--sample[The sample whose rays are printed: its column and row in the pixel]:I,J: ' \
                '--fold[Print secondary rays that add less than N of 255, with those that follow them, as one line]:N: ' \
                '--all[Print every ray, as --fold 0 does]' \
                '--as[text (default)]:text|json|printrays:(text json printrays)' \
                '--origin[Where pixel 0,0 is]:top-left|bottom-left:(top-left bottom-left)' \
                '--why-not[Explain only this light'\''s effect]:LIGHT: ' \
                '--overlay[Also render the picture, with the pixel'\''s rays drawn over it]:OUT.png:_files' \
                '(-s --size)'{-s,--size}'[Size in pixels]:WxH: ' \
                '--shading[How surfaces are shaded]:phong|blinn-phong|diffuse|color|normals:(phong blinn-phong diffuse color normals)' \
                '--no-shadows[No shadows: every light reaches every surface]' \
                '--reflections[Largest number of successive reflections]:N: ' \
                '--aa[N x N samples per pixel]:N|adaptive\:N[\:T]:(N adaptive:N[:T])' \
                '--seed[Number of another picture of everything that is sampled]:N: ' \
                '--alpha[The background is transparent: PNG and OpenEXR have an alpha channel]' \
                '--transfer[none: the numbers as computed]:none|srgb:(none srgb)' \
                '--bits[Bits per channel of PNG and PPM: 8 (default) or 16]:8|16:(8 16)' \
                '--isa[Instruction set (`glint info --isa` lists them)]:NAME:{compadd -- $(glint info --isa 2>/dev/null)}' ;;
        compare)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:FILE:_files' \
                '--within[A pixel may differ by N 255ths (default: 2 for the report; no limit)]:N: ' \
                '--fail-percent[P percent of the pixels may differ by more than --within]:P: ' \
                '--hard-fail[No pixel may differ by more than N 255ths]:N: ' \
                '--diff[Write |A - B| as a PNG, amplified so that the largest difference is white]:OUT.png:_files' \
                '--vary[Render a scene with each value of a setting]:KEY=VALUES:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '*--scene[The scene of B: causes are tested by rendering it]:FILE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene-name[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '(-s --size)'{-s,--size}'[Size in pixels]:WxH: ' \
                '--shading[How surfaces are shaded]:phong|blinn-phong|diffuse|color|normals:(phong blinn-phong diffuse color normals)' \
                '--no-shadows[No shadows: every light reaches every surface]' \
                '--reflections[Largest number of successive reflections]:N: ' \
                '--aa[N x N samples per pixel]:N|adaptive\:N[\:T]:(N adaptive:N[:T])' \
                '--seed[Number of another picture of everything that is sampled]:N: ' \
                '(-t --threads)'{-t,--threads}'[Number of threads]:N: ' \
                '--max-memory[Use at most this memory for the pictures and the comparison: 500M, 4G (default: what they need)]:SIZE: ' \
                '--no-causes[Print only the figures]' \
                '--json[Print JSON]' \
                '(-q --quiet)'{-q,--quiet}'[Print only errors]' ;;
        versus)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:SCENE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--max-memory[The most memory that reading the scene may take: 500M, 4G (default: 2 GiB and 256 times the length of its files)]:SIZE: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '*--a[A setting of the first picture: a convention, a render setting, or profile=NAME]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed= profile=}' \
                '*--b[The same for the second picture]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed= profile=}' \
                '--match-exponents[With Blinn-Phong, multiply exponents by 4: highlights are then about as wide as Phong'\''s]' \
                '(-o --output)'{-o,--output}'[Write both pictures and their difference side by side]:OUT.png:_files' \
                '--json[Print JSON]' \
                '(-s --size)'{-s,--size}'[Size in pixels]:WxH: ' \
                '--shading[How surfaces are shaded]:phong|blinn-phong|diffuse|color|normals:(phong blinn-phong diffuse color normals)' \
                '--no-shadows[No shadows: every light reaches every surface]' \
                '--reflections[Largest number of successive reflections]:N: ' \
                '--aa[N x N samples per pixel]:N|adaptive\:N[\:T]:(N adaptive:N[:T])' \
                '--seed[Number of another picture of everything that is sampled]:N: ' ;;
        grade)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                ':DIR:_files -/' \
                '--reference[The right picture]:PICTURE:_files' \
                '*--scene[The scene of the task: for the causes and for a rubric'\''s parts]:FILE:_files -g "*.(cgfs|json|js|pov|nff|dat|glint)"' \
                '--scene-name[The scene to use, if the file has several]:NAME: ' \
                '*--include-path[A folder with files that the scene includes and that are not beside it]:DIR: ' \
                '--format[The scene'\''s format]:cgfs|epfl|csc473|povray|nff|tachyon|glint:(cgfs epfl csc473 povray nff tachyon glint)' \
                '--profile[Conventions to start from instead of the format'\''s: cgfs, epfl, lecture5, light, csc473, povray, nff, tachyon and glint]:NAME|FILE:{compadd -- cgfs epfl lecture5 light csc473 povray nff tachyon glint; _files}' \
                '*--convention[Set one convention (docs/conventions.md lists them; `glint info SCENE` shows the values in force)]:KEY=VALUE:{compadd -S "" -- pixel_sample= ray_direction= camera_t_min= specular_gate= clamp_cosines= normalize= offset= epsilon= shadow_stops_at_light= mirror= limit= mirror_miss= fresnel= beer= glass_shadow= transparency= opacity= transparent_shadow= transparency_counts= transparent_surfaces= transparent_epsilon= transparent_shadow_epsilon= min_weight= facing= cones= spot_falloff= clamp_attenuation= attenuate_highlights= light_threshold= area_shading= fog_distance= fog_background= fog_extent= transfer= gamma= rounding= size= shading= shadows= reflections= aa= alpha= seed=}' \
                '(-s --size)'{-s,--size}'[Size in pixels]:WxH: ' \
                '--shading[How surfaces are shaded]:phong|blinn-phong|diffuse|color|normals:(phong blinn-phong diffuse color normals)' \
                '--no-shadows[No shadows: every light reaches every surface]' \
                '--reflections[Largest number of successive reflections]:N: ' \
                '--aa[N x N samples per pixel]:N|adaptive\:N[\:T]:(N adaptive:N[:T])' \
                '--seed[Number of another picture of everything that is sampled]:N: ' \
                '--max-memory[The most memory that reading the scene may take: 500M, 4G]:SIZE: ' \
                '--rubric[Lines of PART POINTS FILE \[KEY=VALUE...\] (docs/teaching.md): points per part]:FILE:_files' \
                '--csv[Write the table as CSV]:OUT:_files' \
                '--json[Write all figures and causes as JSON]:OUT:_files' \
                '--gradescope[Write Gradescope'\''s results.json]:OUT:_files' \
                '--prairielearn[Write PrairieLearn'\''s results.json]:OUT:_files' \
                '--pictures[In these results: each wrong picture, and its difference from the right one]' \
                '--hide-causes[In these results: points, without the causes of what is wrong]' \
                '--visibility[Of Gradescope'\''s tests: visible, hidden, after_due_date or after_published]:WHEN: ' \
                '--summary[Write a web page: each mistake of the class with its submissions and some pictures]:OUT.html:_files' \
                '--sheet[Write a PNG of all pictures, each above four times its difference, with the table'\''s numbers and names]:OUT.png:_files' \
                '(-t --threads)'{-t,--threads}'[Number of threads]:N: ' \
                '(-q --quiet)'{-q,--quiet}'[No warnings and no progress]' ;;
        join)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                '*:FILE:_files' \
                '(-o --output)'{-o,--output}'[The picture: .png, .ppm or .exr]:OUT:_files' \
                '--transfer[none: the numbers as computed]:none|srgb:(none srgb)' \
                '--bits[Bits per channel of PNG and PPM: 8 (default) or 16]:8|16:(8 16)' \
                '--partial[Write the picture even if tiles are missing]' \
                '(-q --quiet)'{-q,--quiet}'[Say nothing but errors]' ;;
        completion)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                ':SHELL:(bash zsh fish)' \
                '--program[The program whose script it is]:glint|glint-povray|glint-tachyon:(glint glint-povray glint-tachyon)' ;;
        help)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' \
                ':COMMAND:(render info convert check explain compare versus grade join completion help version)' ;;
        version)
            _arguments \
                '(-h --help)'{-h,--help}'[Print this help message and exit]' ;;
    esac
}
if [[ $funcstack[1] == _glint ]]; then
    _glint "$@"
else
    compdef _glint glint
fi

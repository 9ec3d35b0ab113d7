# SPDX-License-Identifier: Apache-2.0
# Stops at the stages of one pixel of castle, and prints what they have computed (docs/reading_the_code.md):
#   gdb -batch -x tools/one_pixel.gdb --args build/debug/glint render scenes/epfl/castle.json -s 640x640 \
#       --crop 1x1+320+350 --isa scalar -t 1 -q -o pixel.ppm
# With the instruction set "scalar" a vector has one ray. All instruction sets compute the same bits.
set pagination off
set debuginfod enabled off
set print frame-info short-location

define stage
    tbreak $arg0
    continue
end
define scalar_stage
    tbreak glint::N_SCALAR::$arg0
    continue
    finish
end
define show3
    printf "  $arg0 (%g, %g, %g)\n", $arg1[0]._M_elems[0], $arg1[1]._M_elems[0], $arg1[2]._M_elems[0]
end

tbreak glint::load_validated
run
stage prepare_valid
printf "  %d shapes\n", scene.shapes._M_impl._M_finish - scene.shapes._M_impl._M_start
stage glint::render

scalar_stage make_camera_rays
set $d = s.rays.direction
printf "  direction (%g, %g, %g)\n", $d[0]._M_impl._M_start[0], $d[1]._M_impl._M_start[0], $d[2]._M_impl._M_start[0]
scalar_stage intersect
printf "  t %g, slot %d\n", s.hits.t._M_elems[0], s.hits.slot._M_elems[0]
scalar_stage locate_surfaces
show3 point s.surfaces.point
show3 normal s.surfaces.normal
scalar_stage color_surfaces
printf "  material %d\n", s.surfaces.material._M_elems[0]

# The ambient light is a constant of the World, so the first light with stages is the first point light.
scalar_stage sample_light
printf "  N.L %g\n", s.light_samples.n_l._M_elems[0]
scalar_stage find_visibility
printf "  occluded %d\n", s.shadow_rays.occluded._M_elems[0]
scalar_stage add_light
show3 diffuse s.radiance.diffuse
show3 specular s.radiance.specular
scalar_stage add_to_film
scalar_stage resolve
printf "  pixel (%g, %g, %g)\n", job.rgb[0], job.rgb[1], job.rgb[2]
stage glint::encode

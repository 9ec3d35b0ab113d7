# SPDX-License-Identifier: Apache-2.0
"""What of Blender's properties has no effect in glint, and why: one Table for each RNA struct. Names of all versions from
3.3 on; a struct also has those of the structs that it is derived from."""
from typing import NamedTuple


class Table(NamedTuple):
    """Names are separated by spaces. In texts {label} is the property's name in the interface. tests/inside/test_silent.py
    checks that every property of the running Blender is in one of these."""

    read: str = ""
    warned: dict = {}  # text -> names; if the value is not the default
    irrelevant: dict = {}  # reason -> names; * at the end of a name stands for more
    nested: str = ""  # structs that are looked at too
    initially_on: str = ""  # what Blender turns on in new data, though their RNA says that it is off
    initially: dict = {}  # name -> the value in new data, where their RNA has another


BOOKS = "Blender's own records"
DONE = "the depsgraph has applied it"
SHOWN = "the viewport and the interface alone show it"
SAMPLING = "how Cycles and Eevee spend their samples"
PANORAMA = "panoramic cameras are an error"
VOLUMES = "volumes are left out, and reported"
MOTION = "a part of motion blur, which is warned of"
FREESTYLE = "a part of Freestyle, which is warned of"
EEVEE = "Eevee's approximation of what rays do"
WRITTEN = "Blender applies it to the picture of any engine"
BAKE = "baking is not rendering"

NO_VISIBILITY = "its '{label}' is ignored: glint has no ray visibility"
NO_PASS = "its pass '{label}' is not rendered"
NO_CAUSTICS = "its '{label}' is ignored: glint has no caustics"

TABLES = {
    "PropertyGroup": Table(irrelevant={BOOKS: "name"}),
    "ID": Table(irrelevant={BOOKS: (
        "name name_full id_type session_uid is_evaluated original users use_fake_user use_extra_user is_embedded_data is_missing "
        "is_library_indirect is_linked_packed is_runtime_data is_editable library library_weak_reference asset_data "
        "override_library preview tag")}),
    "Object": Table(
        read="data type material_slots matrix_world particle_systems pass_index show_instancer_for_render hide_render "
             "visible_camera is_holdout is_shadow_catcher modifiers glint_shape",
        warned={
            NO_VISIBILITY: "visible_diffuse visible_glossy visible_transmission visible_shadow"},
        initially_on="visible_diffuse visible_glossy visible_transmission visible_shadow",
        irrelevant={
            DONE: "parent* location rotation_* scale dimensions delta_* matrix_local matrix_basis "
                  "matrix_parent_inverse track_axis up_axis constraints animation_data pose pose_library proxy* vertex_groups face_maps grease_pencil_modifiers shader_effects field collision "
                  "soft_body rigid_body rigid_body_constraint instance_* use_instance_* is_instancer is_from_* children* "
                  "users_* use_dynamic_topology_sculpting shape_key_* active_shape_key* use_shape_key_edit_mode "
                  "add_rest_position_attribute use_simulation_cache",
            SHOWN: "active_material active_material_index mode bound_box lock_* hide_viewport hide_select hide_surface* "
                   "display display_* show_name show_axis show_wire show_all_edges show_transparent show_in_front "
                   "show_only_shape_key show_texture_space show_bounds show_empty_image_* show_instancer_for_viewport "
                   "select* use_mesh_mirror_* use_mesh_* animation_visualization motion_path "
                   "use_camera_lock_parent empty_* image_user use_empty_image_alpha use_grease_pencil_lights use_grease_* "
                   "mesh_symmetry_*",
            "the node Object Info, which reads it, is reported": "color",
            "Line Art is Grease Pencil's, which is left out and reported": "lineart",
            "the light groups of the view layer are warned of": "lightgroup",
            VOLUMES: "visible_volume_scatter",
            EEVEE: "hide_probe_*"},
        nested="cycles light_linking"),
    "ObjectLightLinking": Table(
        warned={"light linking is ignored: every light shines on everything": "receiver_collection blocker_collection"}),
    "CyclesObjectSettings": Table(
        warned={
            "its adaptive subdivision is ignored: it has the modifier's levels": "use_adaptive_subdivision",
            "its '{label}' is ignored": "shadow_terminator_offset shadow_terminator_geometry_offset use_camera_cull "
                                        "use_distance_cull",
            NO_CAUSTICS: "is_caustics_caster is_caustics_receiver"},
        irrelevant={
            MOTION: "use_motion_blur use_deform_motion motion_steps",
            "a part of adaptive subdivision": "dicing_rate",
            "a part of Fast GI": "ao_distance"}),

    "Light": Table(
        read="type color energy exposure use_temperature temperature temperature_color use_nodes node_tree use_shadow "
             "shadow_soft_size angle shape size size_y spot_size spot_blend",
        warned={
            "its diffuse and specular factors are ignored, as in Cycles": "diffuse_factor specular_factor transmission_factor",
            "its '{label}' is ignored, as in Cycles": "use_custom_distance falloff_type use_square",
            "its power is taken as that of the whole light": "normalize",
            "its spread is ignored: it shines to all sides of its front": "spread"},
        irrelevant={
            DONE: "animation_data",
            SHOWN: "show_cone",
            VOLUMES: "volume_factor",
            "it has no effect without what is warned of": "cutoff_distance falloff_curve *_coefficient",
            "no renderer of Blender reads it": "shadow_color distance linear_attenuation quadratic_attenuation",
            "how Cycles shows the sphere of a light where it cuts a surface": "use_soft_falloff",
            EEVEE: "shadow_buffer_* shadow_cascade_* contact_shadow_* use_contact_shadow use_shadow_jitter "
                   "shadow_filter_radius shadow_jitter_overblur shadow_maximum_resolution use_absolute_resolution "
                   "shadow_resolution_scale"},
        nested="cycles"),
    "CyclesLightSettings": Table(
        read="cast_shadow is_portal",
        warned={
            "its '{label}' is ignored": "max_bounces",
            NO_CAUSTICS: "is_caustics_light"},
        irrelevant={SAMPLING: "use_multiple_importance_sampling"}),

    "World": Table(
        read="color use_nodes node_tree",
        irrelevant={
            DONE: "animation_data",
            "the light groups of the view layer are warned of": "lightgroup",
            EEVEE: "probe_resolution sun_* use_sun_* use_eevee_finite_volume"},
        nested="light_settings mist_settings cycles cycles_visibility"),
    "WorldLighting": Table(
        warned={"its ambient occlusion is ignored: 'World light is blocked' is glint's": "use_ambient_occlusion"},
        irrelevant={"a part of ambient occlusion": "ao_factor distance"}),
    "WorldMistSettings": Table(
        read="use_mist intensity start depth falloff",
        irrelevant={"no renderer of Blender reads it": "height"}),
    "CyclesWorldSettings": Table(
        warned={NO_CAUSTICS: "is_caustics_light"},
        irrelevant={SAMPLING: "sampling_method sample_map_resolution max_bounces", VOLUMES: "homogeneous_volume volume_*"}),
    "CyclesVisibilitySettings": Table(
        warned={NO_VISIBILITY: "camera diffuse glossy transmission"},
        irrelevant={VOLUMES: "scatter", "a world casts no shadow": "shadow"}),

    "Camera": Table(
        read="type lens lens_unit angle angle_x angle_y sensor_fit sensor_width sensor_height ortho_scale shift_x shift_y "
             "clip_start clip_end",
        irrelevant={
            DONE: "animation_data",
            SHOWN: "display_size show_* passepartout_alpha background_images composition_guide_color",
            "a part of stereoscopy, which is warned of": "stereo",
            PANORAMA: "panorama_type fisheye_* latitude_* longitude_* central_cylindrical_* custom_* cycles cycles_custom"},
        nested="dof"),
    "CameraDOFSettings": Table(
        warned={"depth of field is ignored: everything is sharp": "use_dof"},
        irrelevant={"a part of depth of field": "aperture_* focus_*"}),

    "Material": Table(
        read="diffuse_color metallic roughness specular_intensity use_nodes node_tree pass_index",
        warned={
            "its shadow mode is ignored: 'Shadow of glass' is glint's": "shadow_method",
            "its backface culling is ignored, as in Cycles: both sides are visible": "use_backface_culling use_backface_culling_shadow"},
        irrelevant={
            DONE: "animation_data",
            SHOWN: "preview_render_type use_preview_world texture_paint_* paint_* specular_color line_color line_priority",
            "Grease Pencil and Line Art are left out": "is_grease_pencil grease_pencil lineart",
            "displacement is warned of": "displacement_method max_vertex_displacement",
            VOLUMES: "volume_intersection_method",
            EEVEE: "blend_method alpha_threshold show_transparent_back use_screen_refraction use_sss_translucency "
                   "refraction_depth surface_render_method use_transparency_overlap use_raytrace_refraction thickness_mode "
                   "use_thickness_from_shadow use_transparent_shadow use_backface_culling_lightprobe_volume lightprobe_*"},
        nested="cycles"),
    "CyclesMaterialSettings": Table(
        warned={"its '{label}' is ignored: 'Shadow of glass' is glint's": "use_transparent_shadow"},
        irrelevant={
            SAMPLING: "sample_as_light emission_sampling",
            "displacement is warned of": "displacement_method",
            VOLUMES: "homogeneous_volume volume_*"}),

    "ViewLayer": Table(
        read="material_override use_pass_combined use_pass_z use_pass_normal use_pass_position use_pass_object_index "
             "use_pass_material_index use_pass_diffuse_color use_pass_environment glint",
        warned={
            "its world override is ignored: the scene's world is used": "world_override",
            "its '{label}' is ignored: glint renders it": "use_sky use_solid",
            NO_PASS: "use_pass_mist use_pass_uv use_pass_vector use_pass_ambient_occlusion use_pass_emit use_pass_shadow "
                     "use_pass_diffuse_direct use_pass_diffuse_indirect use_pass_glossy_color use_pass_glossy_direct "
                     "use_pass_glossy_indirect use_pass_transmission_color use_pass_transmission_direct "
                     "use_pass_transmission_indirect use_pass_subsurface_color use_pass_subsurface_direct "
                     "use_pass_subsurface_indirect use_pass_cryptomatte_object use_pass_cryptomatte_material "
                     "use_pass_cryptomatte_asset use_pass_grease_pencil",
            "its shader AOVs are not rendered": "aovs",
            "its light groups are not rendered": "lightgroups"},
        initially_on="use_sky use_solid",
        irrelevant={
            DONE: "layer_collection objects use depsgraph",
            BOOKS: "name active_layer_collection active_aov active_aov_index active_lightgroup active_lightgroup_index has_*",
            SAMPLING: "samples",
            FREESTYLE: "use_freestyle freestyle_settings",
            MOTION: "use_motion_blur",
            VOLUMES: "use_volumes",
            "hair is left out, and reported": "use_strand",
            "Grease Pencil is left out, and reported": "use_grease_pencil",
            "the world's ambient occlusion is warned of": "use_ao",
            "a part of a pass": "pass_alpha_threshold pass_cryptomatte_depth use_pass_cryptomatte_accurate"},
        nested="cycles eevee"),
    "CyclesRenderLayerSettings": Table(
        warned={NO_PASS: "pass_debug_sample_count use_pass_volume_direct use_pass_volume_indirect use_pass_shadow_catcher "
                         "denoising_store_passes use_pass_render_time pass_render_time"},
        irrelevant={SAMPLING: "use_denoising"}),
    "ViewLayerEEVEE": Table(
        warned={NO_PASS: "use_pass_bloom use_pass_volume_direct use_pass_transparent"},
        irrelevant={EEVEE: "ambient_occlusion_distance"}),

    "RenderSettings": Table(
        read="resolution_x resolution_y resolution_percentage pixel_aspect_x pixel_aspect_y use_border use_crop_to_border "
             "border_min_x border_min_y border_max_x border_max_y film_transparent threads threads_mode engine",
        warned={
            "motion blur is ignored": "use_motion_blur",
            "Freestyle lines are ignored": "use_freestyle",
            "stereoscopy is ignored: the right eye is not rendered": "use_multiview",
            "the filter size is ignored: a pixel is the mean of its own area": "filter_size"},
        irrelevant={
            DONE: "frame_map_old frame_map_new fps fps_base use_simplify* simplify_* hair_*",
            WRITTEN: "image_settings ffmpeg filepath dither_intensity use_compositing use_sequencer* use_file_extension "
                     "file_extension is_movie_format use_overwrite use_placeholder use_stamp* stamp_* metadata_input "
                     "use_render_cache compositor_*",
            SHOWN: "preview_pixel_size sequencer_gl_preview use_lock_interface use_persistent_data use_single_layer "
                   "has_multiple_engines",
            BAKE: "bake bake_* use_bake_*",
            MOTION: "motion_blur_*",
            FREESTYLE: "line_thickness line_thickness_mode",
            EEVEE: "use_high_quality_normals",
            "a part of stereoscopy": "views stereo_views views_format use_spherical_stereo"}),
    "CyclesRenderSettings": Table(
        read="max_bounces",
        warned={"Cycles' film '{label}' is ignored": "film_exposure film_transparent_glass"},
        irrelevant={
            SAMPLING: "device feature_set shading_system preview_* use_*denoising denoiser denoising_* samples sample_* "
                      "time_limit sampling_pattern scrambling_distance auto_scrambling_distance use_layer_samples "
                      "light_sampling_threshold use_adaptive_sampling adaptive_* use_preview_* direct_light_sampling_type "
                      "min_*_bounces caustics_* blur_glossy use_guiding* use_deterministic_guiding guiding_* *_guiding "
                      "*_guiding_probability diffuse_bounces glossy_bounces transmission_bounces transparent_max_bounces "
                      "pixel_filter_type filter_width seed use_animated_seed use_light_tree "
                      "use_sample_subset",
            "glint has no Fast GI": "use_fast_gi fast_gi_method ao_bounces ao_bounces_render",
            "culling and adaptive subdivision are warned of by object": "*_cull *_cull_margin *dicing_* max_subdivisions",
            "a part of a transparent glass film": "film_transparent_roughness",
            MOTION: "motion_blur_position rolling_shutter_*",
            VOLUMES: "volume_*",
            BAKE: "bake_type",
            "Cycles' memory and instructions": "debug_* texture_limit* use_auto_tile tile_size"}),
}

# SPDX-License-Identifier: Apache-2.0
"""What of scenes, their color management, collections, meshes and images has no effect in glint, and why. Names of all versions
from 3.3 on."""
from .ignored_table import BOOKS, DONE, EEVEE, MOTION, SAMPLING, SHOWN, VOLUMES, WRITTEN, Table

NO_SOUND = "a picture has no sound"
NO_EEVEE = "Eevee's '{label}' is ignored"
NOT_IN_TEXT = "its '{label}' of the color management is not exported: glint's picture is without it"

SCENE_TABLES = {
    "Scene": Table(
        read="camera world frame_current frame_subframe frame_start frame_end frame_step view_layers collection glint "
             "view_settings display_settings",
        irrelevant={
            DONE: "animation_data objects background_set frame_float frame_current_final gravity use_gravity rigidbody_world "
                  "use_custom_simulation_range simulation_frame_* time_jump_*",
            WRITTEN: "node_tree use_nodes compositing_node_group sequence_editor sequencer_colorspace_settings use_stamp_note",
            SHOWN: "use_preview_range frame_preview_* lock_frame_selection_to_range show_subframe show_keys_from_selected_only "
                   "is_nla_tweakmode sync_mode keying_sets* tool_settings safe_areas timeline_markers transform_orientation_slots "
                   "cursor grease_pencil annotation active_clip display hydra",
            "numbers are exported as they are": "unit_settings",
            NO_SOUND: "use_audio* audio_*",
            "Grease Pencil is left out, and reported": "grease_pencil_settings",
            "hair is left out, and reported": "cycles_curves"},
        nested="render cycles eevee"),
    "SceneEEVEE": Table(
        warned={
            NO_EEVEE: "use_bloom use_motion_blur",
            "Eevee's ambient occlusion is ignored: 'World light is blocked' is glint's": "use_gtao",
            "Eevee's shadows are off, those of glint are not": "use_shadows"},
        irrelevant={
            "a part of bloom": "bloom_*",
            MOTION: "motion_blur_*",
            "a part of Eevee's ambient occlusion": "gtao_* use_gtao_*",
            "a part of depth of field, which is warned of": "bokeh_* use_bokeh_*",
            "glint has no indirect light": "gi_* fast_gi_* use_fast_gi horizon_*",
            VOLUMES: "volumetric_* use_volumetric_* use_volume_custom_range clamp_volume_*",
            SAMPLING: "taa_* use_taa_* sss_* clamp_surface_* use_overscan overscan_size",
            EEVEE: "use_ssr* ssr_* use_raytracing ray_tracing_* shadow_* use_shadow_* use_soft_shadows light_threshold"}),
    "ColorManagedViewSettings": Table(
        warned={NOT_IN_TEXT: "exposure gamma look use_curve_mapping use_white_balance"},
        initially={"look": "None"},
        irrelevant={
            "a text has linear colors; F12's picture is Blender's": "view_transform use_hdr_view is_hdr support_emulation",
            "a part of the curves": "curve_mapping",
            "a part of the white balance": "white_balance_*"}),
    "ColorManagedDisplaySettings": Table(
        warned={NOT_IN_TEXT: "display_device"},
        initially={"display_device": "sRGB"},
        irrelevant={SHOWN: "emulation"}),

    "Collection": Table(
        read="objects all_objects name",
        irrelevant={
            DONE: "children children_recursive collection_children collection_objects instance_offset hide_render hide_viewport "
                  "exporters active_exporter_index",
            SHOWN: "hide_select color_tag",
            "Line Art is Grease Pencil's, which is left out and reported": "lineart_* use_lineart_*"}),
    "LayerCollection": Table(
        read="collection holdout indirect_only",
        irrelevant={BOOKS: "name children", DONE: "exclude hide_viewport is_visible"}),
    "Mesh": Table(
        read="loops polygons vertices loop_triangles loop_triangle_polygons corner_normals uv_layers color_attributes attributes",
        irrelevant={
            DONE: "animation_data shape_keys skin_vertices *_creases materials has_custom_normals normals_domain use_auto_smooth "
                  "auto_smooth_angle has_bevel_weight_* has_crease_* edges",
            "the normals of corners are read": "vertex_normals polygon_normals",
            "another name of color attributes": "vertex_colors sculpt_vertex_colors",
            "another name of attributes": "*_layers_float *_layers_int *_layers_string",
            "of generated coordinates, for which the mean is exported": "texture_mesh texco_mesh *auto_texspace texspace_*",
            SHOWN: "uv_layer_* face_maps vertex_paint_masks remesh_* use_remesh_* use_mirror_* use_paint_* total_* is_editmode",
            "adaptive subdivision is warned of": "cycles"}),
    "Image": Table(
        read="source type filepath packed_file size pixels channels depth is_float has_data alpha_mode colorspace_settings is_dirty "
             "generated_type generated_color",
        irrelevant={
            "the pixels have it": "filepath_raw file_format packed_files generated_width generated_height use_generated_float",
            "of movies and tiles, for which the mean is exported": "use_deinterlace frame_duration tiles",
            "the left eye's pixels are read, as those of the picture": "use_multiview is_multiview is_stereo_3d stereo_3d_format "
                                                                       "views_format",
            "Cycles' memory": "use_half_precision",
            SHOWN: "display_aspect bindcode render_slots resolution seam_margin use_view_as_render animation_data"}),
}

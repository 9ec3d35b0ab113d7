# SPDX-License-Identifier: Apache-2.0
"""The files of textures that glint reads: copied where they can be, else written."""
import filecmp
import os

import bpy
from textured import Textured


class Files(Textured):
    def setUp(self):
        super().setUp()
        self.lamp()

    def save(self, file_format="PNG", name="kept.png", **settings):
        image = self.image(**settings)
        image.filepath_raw, image.file_format = self.path(name), file_format
        image.save()
        bpy.data.images.remove(image)
        return bpy.data.images.load(self.path(name))

    def test_files_on_disk_and_packed_ones_are_copied(self):
        for file_format, name in (("PNG", "kept.png"), ("JPEG", "kept.jpg")):
            image = self.save(file_format, name)
            plane = self.add("plane", material=self.textured(image))
            text = self.export()
            self.assertIn("encoding = srgb", self.block("texture", text))
            (copy,) = self.textures()
            self.assertTrue(filecmp.cmp(self.path(name), self.path(f"scene_textures/{copy}"), shallow=False))
            image.pack()
            os.remove(self.path(name))
            os.remove(self.path(f"scene_textures/{copy}"))
            self.export()
            self.assertEqual(self.textures(), [copy])
            os.remove(self.path(f"scene_textures/{copy}"))
            bpy.data.objects.remove(plane)

    def test_edited_and_generated_images_are_written(self):
        image = self.save()
        self.add("plane", material=self.textured(image))
        image.pixels[:] = [0.2, 0.4, 0.6, 1.0] * 64
        self.assertTrue(image.is_dirty)
        self.export()
        (name,) = self.textures()
        written = bpy.data.images.load(self.path(f"scene_textures/{name}"))
        for got, wanted in zip(written.pixels[:4], (0.2, 0.4, 0.6, 1)):
            self.assertAlmostEqual(got, wanted, delta=0.5 / 255)

    def test_formats_that_glint_does_not_read(self):
        for file_format, name in (("BMP", "a.bmp"), ("TIFF", "a.tif"), ("OPEN_EXR", "a.exr"), ("TARGA", "a.tga")):
            image = self.save(file_format, name)
            plane = self.add("plane", material=self.textured(image))
            self.export()
            self.assertEqual((self.warnings, len(self.textures())), ([], 1), name)
            self.assertTrue(self.textures()[0].endswith(".png"))
            self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"), "--strict")
            os.remove(self.path(f"scene_textures/{self.textures()[0]}"))
            bpy.data.objects.remove(plane)

    def test_f12_and_the_kept_scene(self):
        self.add("plane", material=self.textured(self.image(), interpolation="Linear"))
        self.scene.glint.keep_folder = self.path("kept")
        self.scene.glint.aa = 1
        self.use_engine()
        f12 = self.picture()
        self.assertEqual(len(self.textures("kept/textures")), 1)
        self.export()
        ours = self.layers("background")["beauty"]
        for channel in "RGB":
            self.assertEqual(list(f12.channels[channel]), list(ours.channels[channel]))
        self.assertGreater(len(set(f12.channels["R"])), 200)

    def test_an_animation_writes_an_image_once(self):
        self.add("plane", material=self.textured(self.image()))
        self.scene.frame_start, self.scene.frame_end = 1, 3
        bpy.ops.export_scene.glint(filepath=self.path("film.glint"), animation=True)
        self.assertEqual(len(self.textures("film_textures")), 1)
        self.glint("render", self.path("film.0002.glint"), "-o", self.path("a.png"), "--strict")

    def test_without_numpy(self):
        """What needs no work is copied; the rest is the mean."""
        from io_glint.export import images, mesh_file, mesh_layers  # pylint: disable=import-outside-toplevel
        for module in (images, mesh_file, mesh_layers):
            self.addCleanup(setattr, module, "np", module.np)
        self.add("plane", material=self.textured(self.save()))
        self.add("plane", name="Other", material=self.textured(self.image("made"), "other"), location=(0, 3, 0))
        with_numpy = self.block("mesh", self.export())
        for module in (images, mesh_file, mesh_layers):
            module.np = None
        text = self.export()
        self.assertEqual(self.block("mesh", text), with_numpy)
        self.assertEqual(text.count("\ntexture "), 1)
        self.assertEqual(self.warnings, ["material 'other': the image at 'Base Color' is exported as its mean color: "
                                         "writing it needs numpy"])

    def test_rt2_has_the_mean(self):
        self.add("plane", name="plane", material=self.textured(self.image()))
        color = self.export_rt2()["materials"][0]["color"]
        self.assertAlmostEqual(color[0], 0.1 + 0.8 * 3.5 / 8, delta=0.01)
        self.assertEqual(self.textures(), [])

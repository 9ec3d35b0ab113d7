// mirrored.pov as it was meant: the right vector points right.
camera {
  location <0, 1, 8>
  up <0, 1, 0>
  right <1.33333, 0, 0>
  look_at <0, 0.5, 0>
}
light_source { <6, 8, 6> color rgb <1, 1, 1> }
sphere { <-1.5, 0.5, 0>, 1 pigment { color rgb <0.9, 0.2, 0.2> } finish { ambient 0.2 diffuse 0.7 } }
sphere { <1.2, 0.3, 1>, 0.6 pigment { color rgb <0.2, 0.7, 0.3> } finish { ambient 0.2 diffuse 0.7 } }
plane { <0, 1, 0>, -0.5 pigment { color rgb <0.5, 0.5, 0.6> } finish { ambient 0.2 diffuse 0.6 } }

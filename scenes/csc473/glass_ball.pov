// A ball of glass before two mirrors, over a plane; eggs of one sphere, stretched and turned.

camera {
  location <0, 3.4, 11>
  up <0, 1, 0>
  right <1.33333, 0, 0>
  look_at <0, 1.5, 0>
}

light_source { <-12, 18, 14> color rgb <1.1, 1.05, 0.95> }
light_source { <10, 9, 6> color rgb <0.3, 0.35, 0.45> }

plane { <0, 1, 0>, 0
  pigment { color rgb <0.35, 0.45, 0.5> }
  finish { ambient 0.3 diffuse 0.6 }
}

// the sky: a wall far behind and one far before, as bright as they are
plane { <0, 0, 1>, -60
  pigment { color rgb <0.5, 0.65, 0.85> }
  finish { ambient 0.8 }
}
plane { <0, 0, -1>, -60
  pigment { color rgb <0.85, 0.7, 0.5> }
  finish { ambient 0.8 }
}

// two mirrors, an angle of 100 degrees between them
box { <-5, 0, -0.1>, <5, 5, 0.1>
  pigment { color rgb <0.9, 0.93, 0.92> }
  finish { ambient 0.05 diffuse 0.1 reflection 0.85 }
  rotate <0, 40, 0>
  translate <-3.9, 0, -4>
}
box { <-5, 0, -0.1>, <5, 5, 0.1>
  pigment { color rgb <0.9, 0.93, 0.92> }
  finish { ambient 0.05 diffuse 0.1 reflection 0.85 }
  rotate <0, -40, 0>
  translate <3.9, 0, -4>
}

// the glass ball
sphere { <0, 0, 0>, 1.6
  pigment { color rgbf <0.92, 0.97, 0.95, 0.88> }
  finish { ambient 0.05 diffuse 0.2 specular 0.9 roughness 0.02 ior 1.4 }
  translate <0, 1.6, 2>
}

sphere { <0, 0, 0>, 1
  pigment { color rgb <0.85, 0.25, 0.2> }
  finish { ambient 0.2 diffuse 0.6 specular 0.5 roughness 0.1 }
  scale <0.9, 1.3, 0.9>
  rotate <0, 0, 25>
  translate <-3.2, 1.25, 0.5>
}
sphere { <0, 0, 0>, 1
  pigment { color rgb <0.95, 0.75, 0.2> }
  finish { ambient 0.2 diffuse 0.6 specular 0.5 roughness 0.1 }
  scale <1.4, 0.8, 0.8>
  rotate <0, 50, 0>
  translate <3.1, 0.8, 0.8>
}
sphere { <0, 0.7, 4.6>, 0.45
  pigment { color rgb <0.25, 0.5, 0.8> }
  finish { ambient 0.2 diffuse 0.6 specular 0.5 roughness 0.05 }
  translate <1.9, -0.25, 0>
}
box { <-0.6, 0, -0.6>, <0.6, 1.2, 0.6>
  pigment { color rgb <0.4, 0.65, 0.35> }
  finish { ambient 0.2 diffuse 0.6 }
  rotate <0, 20, 0>
  translate <-2.6, 0, -2.2>
}

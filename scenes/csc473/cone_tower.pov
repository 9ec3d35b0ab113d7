// Stairs of boxes around a tower of cones. The course's own program draws no cones: glint does with
//     glint render cone_tower.pov --convention cones=true

camera {
  location <0, 6.5, 13.5>
  up <0, 1, 0>
  right <1.33333, 0, 0>
  look_at <0, 4.2, 0>
}

light_source { <-30, 40, 30> color rgb <1, 0.95, 0.85> }
light_source { <40, 20, 25> color rgb <0.25, 0.3, 0.45> }

// the ground
plane { <0, 1, 0>, 0
  pigment { color rgb <0.55, 0.65, 0.4> }
  finish { ambient 0.3 diffuse 0.8 }
}

// the sky: a wall far behind, as bright as it is
plane { <0, 0, 1>, -90
  pigment { color rgb <0.55, 0.7, 0.85> }
  finish { ambient 0.8 }
}

// the tower: a trunk, a ledge, a roof
cone { <0, 0, 0>, 2, <0, 6, 0>, 1.3
  pigment { color rgb <0.85, 0.78, 0.65> }
  finish { ambient 0.2 diffuse 0.7 }
}
cone { <0, 6, 0>, 1.3, <0, 6.6, 0>, 1.8
  pigment { color rgb <0.7, 0.6, 0.5> }
  finish { ambient 0.2 diffuse 0.7 }
}
cone { <0, 6.6, 0>, 2.1, <0, 9, 0>, 0
  pigment { color rgb <0.75, 0.2, 0.15> }
  finish { ambient 0.2 diffuse 0.6 specular 0.4 roughness 0.2 }
}
sphere { <0, 9.2, 0>, 0.3
  pigment { color rgb <1, 0.8, 0.3> }
  finish { ambient 0.3 diffuse 0.5 specular 0.8 roughness 0.08 }
}

// one step, turned by -24 degrees and raised by 0.35 again and again
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.250, 0.450, 0.700> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, 30, 0>
  translate <0, 0.35, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.283, 0.443, 0.673> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, 6, 0>
  translate <0, 0.70, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.317, 0.437, 0.647> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -18, 0>
  translate <0, 1.05, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.350, 0.430, 0.620> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -42, 0>
  translate <0, 1.40, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.383, 0.423, 0.593> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -66, 0>
  translate <0, 1.75, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.417, 0.417, 0.567> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -90, 0>
  translate <0, 2.10, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.450, 0.410, 0.540> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -114, 0>
  translate <0, 2.45, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.483, 0.403, 0.513> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -138, 0>
  translate <0, 2.80, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.517, 0.397, 0.487> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -162, 0>
  translate <0, 3.15, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.550, 0.390, 0.460> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -186, 0>
  translate <0, 3.50, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.583, 0.383, 0.433> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -210, 0>
  translate <0, 3.85, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.617, 0.377, 0.407> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -234, 0>
  translate <0, 4.20, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.650, 0.370, 0.380> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -258, 0>
  translate <0, 4.55, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.683, 0.363, 0.353> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -282, 0>
  translate <0, 4.90, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.717, 0.357, 0.327> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -306, 0>
  translate <0, 5.25, 0>
}
box { <1.2, -0.15, -0.5>, <3.6, 0.15, 0.5>
  pigment { color rgb <0.750, 0.350, 0.300> }
  finish { ambient 0.2 diffuse 0.6 specular 0.2 roughness 0.3 }
  rotate <0, -330, 0>
  translate <0, 5.60, 0>
}
